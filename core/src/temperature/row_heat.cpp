#include "row_heat.hpp"

#include <cmath>
#include <numbers>

namespace contactd {

RowHeat::RowHeat(const ThermalBodies& bodies, double velocity, double dx, std::size_t length) {
    const double upper = bodies.upper.effusivity(), lower = bodies.below().effusivity(), both = upper + lower;
    share_of_upper_ = upper / both;
    contact_temperature_ =
        bodies.upper.bulk_temperature * share_of_upper_ + bodies.below().bulk_temperature * (lower / both);
    const double unit = 2 * std::sqrt(dx) / (both * std::sqrt(std::numbers::pi * velocity));
    weights_.resize(length);
    for (std::size_t k = 0; k < length; ++k) {
        const auto elements = static_cast<double>(k);
        // Roots of large numbers nearly cancel: the difference as a quotient.
        weights_[k] = unit * (k == 0 ? std::sqrt(0.5) : 1 / (std::sqrt(elements + 0.5) + std::sqrt(elements - 0.5)));
    }
}

}  // namespace contactd
