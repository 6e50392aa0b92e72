// Computes the rise of the temperature along a row of elements by frictional heat.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "contactd/temperature.hpp"

namespace contactd {

/// Describes how the bodies share the heat of a row, by the speeds at which their surfaces pass through the contact.
struct RowShares {
    double speed_upper = 0, speed_lower = 0;  ///< (mm/s), >= 0
    bool opposite = false;                    ///< whether the surfaces pass in opposite directions
    double share_of_upper = 0;                ///< share of the heat that flows into the upper body
    double contact_temperature = 0;           ///< for both surfaces in contact, without friction (degrees Celsius)
    double unit = 0;                          ///< rise by a heat of 1 N/(mm s) for a weight of 1 (K mm s/N)
};

/// Computes how bodies share heat, and by how much an element's heat raises the temperature behind it.
class RowHeat {
   public:
    /// `velocity` is that of rolling (mm/s), `upper_speed` as in TemperatureRequest; `dx` the size of the elements
    /// along it (mm), `length` their number.
    RowHeat(const ThermalBodies& bodies, double velocity, std::optional<double> upper_speed, double dx,
            std::size_t length);

    /// Returns the shares of a row whose upper surface slips by `slip` over the lower one, per distance rolled,
    /// positive along the rolling direction. Surfaces move against the rolling direction, the lower one faster by
    /// velocity times slip.
    RowShares shares(double slip) const;

    /// Returns the rise at an element by the heat of the one that lies `ahead` elements before it, over the unit of the
    /// row's shares; 0 is the element's own heat.
    double weight(std::size_t ahead) const { return weights_[ahead]; }

   private:
    const ThermalBodies bodies_;
    const double velocity_, scale_;
    const std::optional<double> upper_;  // speed of the upper surface over the velocity
    std::vector<double> weights_;
};

/// Returns the relative motion of the surfaces along x, per distance rolled, in each row of nx elements. It is the mean
/// of slip minus flow (if not empty), weighted with the pressure, and 0 in rows without contact.
std::vector<double> mean_slip_of_rows(std::size_t nx, std::span<const double> pressure, std::span<const double> slip_x,
                                      std::span<const double> flow_x);

}  // namespace contactd
