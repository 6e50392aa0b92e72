#include "geometry/conicity/radius_difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/conicity/bracketed_root.hpp"

namespace contactd::geometry {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int turn = 3600;                                // places of a turn
constexpr double first_step = 0.1, smallest_step = 1e-3;  // mm

struct Sample {
    double shift, value;
};

/// What lies between two samples, and the second one.
void fill(std::vector<Sample>& samples, const Sample& from, const Sample& to, double tolerance,
          const std::function<double(double)>& difference) {
    const double shift = (from.shift + to.shift) / 2;
    if (to.shift - from.shift > smallest_step) {
        const Sample middle{shift, difference(shift)};
        if (std::abs(middle.value - (from.value + to.value) / 2) > tolerance) {
            fill(samples, from, middle, tolerance, difference);
            fill(samples, middle, to, tolerance, difference);
            return;
        }
        samples.push_back(middle);
    }
    samples.push_back(to);
}

}  // namespace

RadiusDifference::RadiusDifference(double reach, double tolerance, const std::function<double(double)>& difference)
    : reach_(reach) {
    const auto half = static_cast<int>(std::ceil(reach / first_step));
    std::vector<Sample> samples{{-reach, difference(-reach)}};
    for (int i = 1 - half; i <= half; ++i) {
        const double shift = reach * i / half;
        fill(samples, Sample(samples.back()), {shift, difference(shift)}, tolerance, difference);
    }
    std::vector<double> shifts;
    for (const Sample& sample : samples) {
        integrals_.push_back(shifts.empty() ? 0
                                            : integrals_.back() +
                                                  (sample.shift - shifts.back()) * (values_.back() + sample.value) / 2);
        shifts.push_back(sample.shift);
        values_.push_back(sample.value);
    }
    find_ = IntervalFinder(std::move(shifts));
}

double RadiusDifference::operator()(double shift) const {
    const auto& shifts = find_.values();
    const std::size_t i = find_(std::max(shift, -reach_));
    return values_[i] + (shift - shifts[i]) / (shifts[i + 1] - shifts[i]) * (values_[i + 1] - values_[i]);
}

double RadiusDifference::potential(double shift) const {
    const auto& shifts = find_.values();
    const std::size_t i = find_(std::max(shift, -reach_));
    const double into = shift - shifts[i], slope = (values_[i + 1] - values_[i]) / (shifts[i + 1] - shifts[i]);
    return integrals_[i] + into * (values_[i] + into / 2 * slope);
}

double RadiusDifference::centre(double amplitude, const std::function<double(double)>& function) const {
    const double room = reach_ - amplitude;
    const double at_low = function(-room), at_high = function(room);
    if (!(at_low < 0 && at_high > 0)) return function(0) == 0 ? 0 : std::numeric_limits<double>::quiet_NaN();
    return bracketed_root(-room, room, at_low, at_high, 1e-12, function);
}

double RadiusDifference::harmonic(double amplitude) const {
    const auto moment = [&](double y, bool weighted) {
        double sum = 0;
        for (int k = 0; k < turn; ++k) {
            const double sine = std::sin(2 * pi * (k + 0.5) / turn);
            sum += (*this)(y + amplitude * sine) * (weighted ? sine : 1);
        }
        return sum * 2 * pi / turn;
    };
    const double y = centre(amplitude, [&](double middle) { return moment(middle, false); });
    return std::isnan(y) ? y : moment(y, true) / (2 * pi * amplitude);
}

double RadiusDifference::half_swing(double amplitude) const {
    const auto unevenness = [&](double y) { return potential(y + amplitude) - potential(y - amplitude); };
    const double y = centre(amplitude, unevenness);
    if (std::isnan(y)) return y;
    const double ends = (potential(y + amplitude) + potential(y - amplitude)) / 2;
    double sum = 0;
    for (int k = 0; k < turn; ++k) {  // y + A sin t: the integrand is smooth up to the ends
        const double t = pi * ((k + 0.5) / turn - 0.5);
        sum += amplitude * std::cos(t) / std::sqrt(2 * (ends - potential(y + amplitude * std::sin(t))));
    }
    return std::isfinite(sum) ? sum * pi / turn : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace contactd::geometry
