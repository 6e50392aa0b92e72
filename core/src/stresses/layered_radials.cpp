#include "layered_radials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "influence/layered/gauss_legendre.hpp"
#include "influence/layered/wavenumbers.hpp"

namespace contactd {
namespace {

using Values = StressRadial::Values;
using enum StressRadial::Function;

constexpr double per_two_pi = 0.5 / std::numbers::pi;
constexpr double smallest = 1e-9;  // limit of k times a distance; smaller values have no effect

Values spectra(const StressWave& wave) {
    const auto& [n, t, yz, xy] = wave;
    Values values{};
    values[normal_zz] = n.zz;
    values[normal_yy] = n.yy;
    values[normal_difference] = n.xx - n.yy;
    values[across_yz] = yz;
    values[shear_difference] = t.xz - yz;
    values[normal_xz] = n.xz;
    values[shear_zz] = t.zz;
    values[shear_xx] = t.xx;
    values[shear_yy] = t.yy;
    values[across_xy] = xy;
    values[third] = t.xx - t.yy - 2 * xy;
    return values;
}

/// Adds spectra times the Bessel functions of their kernels.
void add(const Values& spectrum, double J0, double J1, double J2, Values& sum) {
    for (std::size_t f = 0; f < spectrum.size(); ++f)
        sum[f] += spectrum[f] * (f < normal_xz ? J1 : f < third ? J0 : J2);
}

double second_bessel(double z, double J0, double J1) {
    return z < 0.1 ? z * z / 8 * (1 - z * z / 12 * (1 - z * z / 32)) : 2 * J1 / z - J0;
}

/// Integrates the spectra times powers of k from 0 on, in panels that grow with k.
class Moments {
   public:
    Moments(const StressWaves& waves, double first) : waves_(waves), gauss_(gauss_legendre(20)), next_(first) {
        add_panel(0, first);
    }
    void extend(double to) {
        for (; below_ < to; next_ *= 2) add_panel(below_, std::min(next_, to));
    }
    /// Returns the integrals up to `below_`, at a distance rho with k rho << 1.
    Values at(double rho) const {
        Values sum{};
        for (std::size_t f = 0; f < sum.size(); ++f) {
            const auto& m = powers_;
            sum[f] = f < normal_xz ? rho / 2 * (m[1][f] - rho * rho / 8 * m[3][f])
                     : f < third   ? m[0][f] - rho * rho / 4 * m[2][f]
                                   : rho * rho / 8 * m[2][f];
        }
        return sum;
    }

   private:
    void add_panel(double from, double to) {
        for (const auto& [node, weight] : gauss_) {
            const double k = from + node * (to - from);
            const Values spectrum = spectra(waves_.at(k));
            double power = weight * (to - from);
            for (Values& moment : powers_) {
                for (std::size_t f = 0; f < spectrum.size(); ++f) moment[f] += power * spectrum[f];
                power *= k;
            }
        }
        below_ = to;
    }

    const StressWaves& waves_;
    std::vector<GaussPoint> gauss_;
    double below_ = 0, next_;
    std::array<Values, 4> powers_{};
};

/// Returns the values at the distances p rho of the wavenumbers' rule; `below` contains the integrals up to its least
/// wavenumber.
std::vector<Values> at_octave(const StressWaves& waves, double p, const Moments& below) {
    const Wavenumbers& rule = wavenumbers();
    std::vector<Values> result;
    for (const double rho : rule.rho) result.push_back(below.at(p * rho));
    const double last = 45 * p / waves.scale();
    for (std::size_t i = 0; i < rule.k.size() && rule.k[i] < last; ++i) {
        Values spectrum = spectra(waves.at(rule.k[i] / p));
        for (double& value : spectrum) value *= rule.weight[i] / p;
        for (std::size_t r = 0; r < result.size(); ++r) {
            const double J0 = 1 + rule.J0_less_1[r][i], J1 = rule.J1[r][i];
            add(spectrum, J0, J1, second_bessel(rule.k[i] * rule.rho[r], J0, J1), result[r]);
        }
    }
    return result;
}

/// Returns the values at the distances rho, which are at most `largest` and not above the scale.
std::vector<Values> near(const StressWaves& waves, const std::vector<double>& rho, double largest) {
    const std::vector<GaussPoint> gauss = gauss_legendre(20);
    std::vector<Values> result(rho.size());
    const double last = 45 / waves.scale(), widest = 6 / waves.scale();
    double from = 0, to = smallest / std::max(largest, waves.scale());
    while (from < last) {
        for (const auto& [node, weight] : gauss) {
            const double k = from + node * (to - from);
            Values spectrum = spectra(waves.at(k));
            for (double& value : spectrum) value *= weight * (to - from);
            for (std::size_t r = 0; r < rho.size(); ++r) {
                const double z = k * rho[r], J0 = ::j0(z), J1 = ::j1(z);
                add(spectrum, J0, J1, second_bessel(z, J0, J1), result[r]);
            }
        }
        const double width = std::min(to, widest);
        from = to;
        to = from + width;
    }
    return result;
}

}  // namespace

StressRadials::StressRadials(const StressWaves& waves, double largest) : first_(std::min(waves.scale(), largest)) {
    const auto& chebyshev = wavenumbers().chebyshev;
    const auto add_interval = [&](const std::vector<Values>& values) {
        Interval coefficients{};
        for (std::size_t n = 0; n < nodes; ++n)
            for (std::size_t i = 0; i < nodes; ++i) {
                const double polynomial = std::cos(static_cast<double>(n) * std::acos(chebyshev[i]));
                const double factor = per_two_pi * (n == 0 ? 1.0 : 2.0) / nodes * polynomial;
                for (std::size_t f = 0; f < StressRadial::count; ++f) coefficients[n][f] += factor * values[i][f];
            }
        intervals_.push_back(coefficients);
    };
    const int octaves = largest > first_ ? static_cast<int>(std::ceil(std::log2(largest / first_))) : 0;
    if (octaves > 0) {
        Moments moments(waves, smallest / std::ldexp(first_, octaves));
        for (int octave = octaves; octave-- > 0;) {
            const double p = std::ldexp(first_, octave);
            moments.extend(Wavenumbers::least / p);
            add_interval(at_octave(waves, p, moments));
        }
    }
    std::vector<double> rho;
    for (const double x : chebyshev) rho.push_back(first_ * (1 + x) / 2);
    add_interval(near(waves, rho, first_));
    std::reverse(intervals_.begin(), intervals_.end());
}

StressRadial::Values StressRadials::at(double rho) const {
    std::size_t interval = 0;
    double x = 2 * rho / first_ - 1;
    if (rho > first_ && intervals_.size() > 1) {
        const int octave = std::min(std::ilogb(rho / first_), static_cast<int>(intervals_.size()) - 2);
        interval = static_cast<std::size_t>(octave) + 1;
        x = 2 * std::ldexp(rho / first_, -octave) - 3;
    }
    const Interval& coefficients = intervals_[interval];
    Values b1{}, b2{};  // for Clenshaw's recurrence
    for (std::size_t n = nodes - 1; n > 0; --n)
        for (std::size_t f = 0; f < b1.size(); ++f) {
            const double b0 = coefficients[n][f] + 2 * x * b1[f] - b2[f];
            b2[f] = b1[f];
            b1[f] = b0;
        }
    Values result;
    for (std::size_t f = 0; f < result.size(); ++f) result[f] = coefficients[0][f] + x * b1[f] - b2[f];
    return result;
}

}  // namespace contactd
