// Computes one approach of each model of virtual penetration.
#pragma once

#include <vector>

#include "distance_rows.hpp"

namespace contactd {

struct PenetrationPressures {
    std::vector<double> pressure;
    bool is_beyond = false;  ///< whether some rows are outside the range of the model
};

/// Returns half ellipses over rows, without their factor.
PenetrationPressures kp_shape(const DistanceRows& rows, double d);
/// Returns half ellipses over rows, without their factor; `compliance` is as in hertz.hpp.
PenetrationPressures kpec_shape(const DistanceRows& rows, double d, double compliance);
/// Returns pressures with their factor.
PenetrationPressures analyn_pressures(const DistanceRows& rows, double d, double compliance);

}  // namespace contactd
