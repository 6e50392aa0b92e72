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
constexpr int turn = 3600;          // points of a turn
constexpr double first_step = 0.1;  // mm
// A leap of the contact becomes a ramp of this width (mm), which decides the motion just beyond the leap.
constexpr double smallest_step = 1e-5;

}  // namespace

RadiusDifference::RadiusDifference(Reach reach, double tolerance, std::function<double(double)> difference)
    : reach_(reach), tolerance_(tolerance), difference_(std::move(difference)) {
    const auto steps_to = [](double end) { return static_cast<int>(std::ceil(std::abs(end) / first_step)); };
    const int below = steps_to(reach.low), above = steps_to(reach.high);
    std::vector<double> shifts;
    for (int i = below; i > 0; --i) shifts.push_back(reach.low * i / below);
    for (int i = 0; i <= above; ++i) shifts.push_back(reach.high * i / above);
    take(sampled(shifts));
}

void RadiusDifference::extend(Reach reach) {
    const auto stretch = [&](double from, double to) {
        const int steps = static_cast<int>(std::ceil((to - from) / first_step));
        std::vector<double> shifts;
        for (int i = 0; i <= steps; ++i) shifts.push_back(from + (to - from) * i / steps);
        return steps > 0 ? sampled(shifts) : std::vector<Sample>{};
    };
    std::vector<Sample> samples = stretch(reach.low, reach_.low);
    if (!samples.empty()) samples.pop_back();  // It is already known.
    for (std::size_t i = 0; i < values_.size(); ++i) samples.push_back({find_.values()[i], values_[i]});
    const std::vector<Sample> above = stretch(reach_.high, reach.high);
    if (!above.empty()) samples.insert(samples.end(), above.begin() + 1, above.end());
    reach_ = reach;
    take(samples);
}

std::vector<RadiusDifference::Sample> RadiusDifference::sampled(const std::vector<double>& shifts) const {
    std::vector<Sample> samples{{shifts.front(), difference_(shifts.front())}};
    for (std::size_t i = 1; i < shifts.size(); ++i)
        fill(samples, Sample(samples.back()), {shifts[i], difference_(shifts[i])});
    return samples;
}

/// Appends the samples between two, and the second one.
void RadiusDifference::fill(std::vector<Sample>& samples, const Sample& from, const Sample& to) const {
    const double shift = (from.shift + to.shift) / 2;
    if (to.shift - from.shift > smallest_step) {
        const Sample middle{shift, difference_(shift)};
        if (std::abs(middle.value - (from.value + to.value) / 2) > tolerance_) {
            fill(samples, from, middle);
            fill(samples, middle, to);
            return;
        }
        samples.push_back(middle);
    }
    samples.push_back(to);
}

void RadiusDifference::take(const std::vector<Sample>& samples) {
    std::vector<double> shifts;
    values_.clear();
    integrals_.clear();
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
    const std::size_t i = find_(std::max(shift, reach_.low));
    return values_[i] + (shift - shifts[i]) / (shifts[i + 1] - shifts[i]) * (values_[i + 1] - values_[i]);
}

double RadiusDifference::potential(double shift) const {
    const auto& shifts = find_.values();
    const std::size_t i = find_(std::max(shift, reach_.low));
    const double into = shift - shifts[i], slope = (values_[i + 1] - values_[i]) / (shifts[i + 1] - shifts[i]);
    return integrals_[i] + into * (values_[i] + into / 2 * slope);
}

double RadiusDifference::centre(double amplitude, const std::function<double(double)>& function) const {
    const double low = reach_.low + amplitude, high = reach_.high - amplitude;
    const double at_low = function(low), at_high = function(high);
    if (!(at_low < 0 && at_high > 0)) return function(0) == 0 ? 0 : std::numeric_limits<double>::quiet_NaN();
    return bracketed_root(low, high, at_low, at_high, 1e-12, function);
}

double RadiusDifference::unevenness(double amplitude, double centre) const {
    return potential(centre + amplitude) - potential(centre - amplitude);
}

double RadiusDifference::centre(double amplitude) const {
    return centre(amplitude, [&](double middle) { return unevenness(amplitude, middle); });
}

int RadiusDifference::side_of_centre(double amplitude) const {
    const auto side = [&](const auto& function) {
        const double at_low = function(reach_.low + amplitude), at_high = function(reach_.high - amplitude);
        return at_low > 0 && at_high > 0 ? -1 : at_low < 0 && at_high < 0 ? 1 : 0;
    };
    const int of_swing = side([&](double middle) { return unevenness(amplitude, middle); });
    return of_swing != 0 ? of_swing : side([&](double middle) { return moment(amplitude, middle, false); });
}

double RadiusDifference::largest_between(double from, double to) const {
    double largest = std::max(std::abs((*this)(from)), std::abs((*this)(to)));
    const auto& shifts = find_.values();
    for (std::size_t i = 0; i < shifts.size(); ++i)
        if (shifts[i] > from && shifts[i] < to) largest = std::max(largest, std::abs(values_[i]));
    return largest;
}

// A difference of the size of rounding errors vanishes. So does one below the precision of the profiles if there is no
// oscillation: points of a cylinder deviate from it by less.
bool RadiusDifference::vanishes(double amplitude) const {
    constexpr double rounding = 1e-9, least_conicity = 1e-3;  // mm; least conicity of interest
    const double y = centre(amplitude), middle = std::isnan(y) ? 0 : y;
    const double largest = largest_between(middle - amplitude, middle + amplitude);
    if (largest <= rounding) return true;
    const bool swings = std::isfinite(half_swing_around(amplitude, y));
    return !swings && largest <= std::min(tolerance_, 2 * amplitude * least_conicity);
}

double RadiusDifference::moment(double amplitude, double centre, bool weighted) const {
    double sum = 0;
    for (int k = 0; k < turn; ++k) {
        const double sine = std::sin(2 * pi * (k + 0.5) / turn);
        sum += (*this)(centre + amplitude * sine) * (weighted ? sine : 1);
    }
    return sum * 2 * pi / turn;
}

double RadiusDifference::harmonic(double amplitude) const {
    if (vanishes(amplitude)) return 0;
    const double y = centre(amplitude, [&](double middle) { return moment(amplitude, middle, false); });
    return std::isnan(y) ? y : moment(amplitude, y, true) / (2 * pi * amplitude);
}

double RadiusDifference::half_swing(double amplitude) const {
    if (vanishes(amplitude)) return std::numeric_limits<double>::infinity();
    return half_swing_around(amplitude, centre(amplitude));
}

double RadiusDifference::half_swing_around(double amplitude, double y) const {
    if (std::isnan(y)) return y;
    const double ends = (potential(y + amplitude) + potential(y - amplitude)) / 2;
    double sum = 0;
    for (int k = 0; k < turn; ++k) {  // With y + A sin t, the integrand is smooth up to the ends.
        const double t = pi * ((k + 0.5) / turn - 0.5);
        sum += amplitude * std::cos(t) / std::sqrt(2 * (ends - potential(y + amplitude * std::sin(t))));
    }
    return std::isfinite(sum) ? sum * pi / turn : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace contactd::geometry
