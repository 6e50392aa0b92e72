#include "influence/layered/wavenumbers.hpp"

#include <math.h>  // for j0 and j1 of POSIX

#include <cmath>
#include <numbers>

#include "influence/layered/gauss_legendre.hpp"

namespace contactd {
namespace {

constexpr double window_middle = 66, window_width = 12, last = 132;  // of k p
constexpr double growing_until = 4;
constexpr int uniform_panels = 26, points = 20;  // at most 10 radians of k rho for each panel

// Returns J_order minus its first term, for small z.
double remainder_of_series(int order, double z) {
    double term = order == 0 ? 1 : z / 2, sum = 0;
    for (int n = 1; n <= 12; ++n) {
        term *= -z * z / 4 / (n * (n + order));
        sum += term;
    }
    return sum;
}

void fill_panels(Wavenumbers& rule) {
    const std::vector<GaussPoint> gauss = gauss_legendre(points);
    const auto add = [&](double from, double to) {
        for (const auto& [node, weight] : gauss) {
            const double k = from + node * (to - from);
            rule.k.push_back(k);
            rule.weight.push_back(weight * (to - from) * std::erfc((k - window_middle) / window_width) / 2);
        }
    };
    for (double from = Wavenumbers::least; from < growing_until; from *= 2) add(from, 2 * from);
    const double width = (last - growing_until) / uniform_panels;
    for (int panel = 0; panel < uniform_panels; ++panel)
        add(growing_until + panel * width, growing_until + (panel + 1) * width);
}

Wavenumbers make_wavenumbers() {
    Wavenumbers rule;
    fill_panels(rule);
    for (std::size_t i = 0; i < Wavenumbers::radii; ++i) {
        rule.chebyshev[i] = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.5) / Wavenumbers::radii);
        rule.rho[i] = (3 + rule.chebyshev[i]) / 2;
        for (const double k : rule.k) {
            const double z = k * rule.rho[i];
            const bool small = z < 1;
            const double first = ::j1(z);
            rule.J1[i].push_back(first);
            rule.J0_less_1[i].push_back(small ? remainder_of_series(0, z) : ::j0(z) - 1);
            rule.J1_less_half[i].push_back(small ? remainder_of_series(1, z) : first - z / 2);
        }
    }
    return rule;
}

}  // namespace

const Wavenumbers& wavenumbers() {
    static const Wavenumbers rule = make_wavenumbers();
    return rule;
}

}  // namespace contactd
