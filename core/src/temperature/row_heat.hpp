// Rise of the temperature along a row of elements by the heat of its friction.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/temperature.hpp"

namespace contactd {

/// How bodies share heat, and how much an element's heat raises what lies behind it.
class RowHeat {
   public:
    /// `velocity` is that of rolling (mm/s), `dx` the size of the elements along it (mm), `length` their number.
    RowHeat(const ThermalBodies& bodies, double velocity, double dx, std::size_t length);

    /// The rise at an element by a heat of 1 N/(mm s) on the one that lies `ahead` elements before it; 0: on its own
    /// (K mm s/N).
    double weight(std::size_t ahead) const { return weights_[ahead]; }
    double share_of_upper() const { return share_of_upper_; }
    /// The temperature of both surfaces in contact, without friction (degrees Celsius).
    double contact_temperature() const { return contact_temperature_; }

   private:
    double share_of_upper_, contact_temperature_;
    std::vector<double> weights_;
};

}  // namespace contactd
