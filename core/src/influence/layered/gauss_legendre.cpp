#include "influence/layered/gauss_legendre.hpp"

#include <cmath>
#include <numbers>

namespace contactd {

std::vector<GaussPoint> gauss_legendre(int points) {
    std::vector<GaussPoint> rule(static_cast<std::size_t>(points));
    for (int i = 0; i < points; ++i) {
        double x = -std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5)), slope = 1;
        for (int step = 0; step < 8; ++step) {
            double before = 1, value = x;
            for (int n = 2; n <= points; ++n) {
                const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
                before = value;
                value = next;
            }
            slope = points * (x * value - before) / (x * x - 1);
            x -= value / slope;
        }
        rule[static_cast<std::size_t>(i)] = {(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)};
    }
    return rule;
}

}  // namespace contactd
