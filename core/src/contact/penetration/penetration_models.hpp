// One approach of each model of virtual penetration.
#pragma once

#include <vector>

#include "distance_rows.hpp"

namespace contactd {

struct PenetrationPressures {
    std::vector<double> pressure;
    bool is_beyond = false;  ///< whether some rows are no such surfaces as the model is made for
};

/// Half ellipses over rows, their factor left open.
PenetrationPressures kp_shape(const DistanceRows& rows, double d);
/// `compliance` as in hertz.hpp.
PenetrationPressures kpec_shape(const DistanceRows& rows, double d, double compliance);
/// Pressures themselves.
PenetrationPressures analyn_pressures(const DistanceRows& rows, double d, double compliance);

}  // namespace contactd
