#include "row_heat.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace contactd {

RowHeat::RowHeat(const ThermalBodies& bodies, double velocity, std::optional<double> upper_speed, double dx,
                 std::size_t length)
    : bodies_(bodies),
      velocity_(velocity),
      scale_(2 * std::sqrt(dx) / std::sqrt(std::numbers::pi * velocity)),
      upper_(upper_speed ? std::optional(*upper_speed / velocity) : std::nullopt),
      weights_(length) {
    for (std::size_t k = 0; k < length; ++k) {
        const auto elements = static_cast<double>(k);
        // The quotient avoids the cancellation of the roots of large numbers.
        weights_[k] = k == 0 ? std::sqrt(0.5) : 1 / (std::sqrt(elements + 0.5) + std::sqrt(elements - 0.5));
    }
}

// While its surface passes through the contact, a body absorbs heat in proportion to its effusivity and the root of its
// speed.
RowShares RowHeat::shares(double slip) const {
    constexpr double least = 1e-12;  // fraction of the velocity; the heat must flow into one of the bodies
    const double above = upper_ ? *upper_ : 1 - 0.5 * slip, below = upper_ ? *upper_ + slip : 1 + 0.5 * slip;
    const auto root = [least](double part) { return std::sqrt(std::max(std::abs(part), least)); };
    const double upper = bodies_.upper.effusivity() * root(above), lower = bodies_.below().effusivity() * root(below),
                 both = upper + lower;
    RowShares shares;
    shares.speed_upper = velocity_ * std::abs(above);
    shares.speed_lower = velocity_ * std::abs(below);
    shares.opposite = above * below < 0;
    shares.share_of_upper = upper / both;
    shares.contact_temperature =
        bodies_.upper.bulk_temperature * shares.share_of_upper + bodies_.below().bulk_temperature * (lower / both);
    shares.unit = scale_ / both;
    return shares;
}

std::vector<double> mean_slip_of_rows(std::size_t nx, std::span<const double> pressure, std::span<const double> slip_x,
                                      std::span<const double> flow_x) {
    std::vector<double> means(pressure.size() / nx);
    for (std::size_t row = 0; row < means.size(); ++row) {
        double sum = 0, weight = 0;
        for (std::size_t i = row * nx; i < (row + 1) * nx; ++i) {
            if (!(pressure[i] > 0)) continue;
            sum += pressure[i] * (slip_x[i] - (flow_x.empty() ? 0 : flow_x[i]));
            weight += pressure[i];
        }
        if (weight > 0) means[row] = sum / weight;
    }
    return means;
}

}  // namespace contactd
