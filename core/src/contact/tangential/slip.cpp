#include "slip.hpp"

#include "contact/support/solver_support.hpp"

namespace contactd {

SlipDistance slip_distance(const InfluenceOperator& influence, std::span<const double> bound,
                           std::span<const double> rigid_x, std::span<const double> rigid_y,
                           std::span<const double> traction_x, std::span<const double> traction_y) {
    const std::size_t n = influence.size();
    require_size(bound, n, "bound");
    require_size(rigid_x, n, "rigid_x");
    require_size(rigid_y, n, "rigid_y");
    require_size(traction_x, n, "traction_x");
    require_size(traction_y, n, "traction_y");
    SlipDistance slip{std::vector<double>(n), std::vector<double>(n)};
    influence.tangential(traction_x, traction_y, slip.x, slip.y);
    for (std::size_t i = 0; i < n; ++i) {
        slip.x[i] = bound[i] > 0 ? slip.x[i] + rigid_x[i] : 0;
        slip.y[i] = bound[i] > 0 ? slip.y[i] + rigid_y[i] : 0;
    }
    return slip;
}

}  // namespace contactd
