#include "geometry/profile/natural_spline.hpp"

namespace contactd::geometry {

std::vector<double> natural_curving(std::span<const double> knots, std::span<const double> values) {
    const std::size_t n = knots.size();
    std::vector<double> curving(n, 0.0), upper(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {  // forward elimination
        const double before = knots[i] - knots[i - 1], behind = knots[i + 1] - knots[i];
        const double slope_change = (values[i + 1] - values[i]) / behind - (values[i] - values[i - 1]) / before;
        const double pivot = 2 * (before + behind) - before * upper[i - 1];
        upper[i] = behind / pivot;
        curving[i] = (6 * slope_change - before * curving[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;) curving[i] -= upper[i] * curving[i + 1];
    return curving;
}

}  // namespace contactd::geometry
