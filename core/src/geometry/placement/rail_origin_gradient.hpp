// Converts a gradient by the origin of a rail to one by its profile, which determines the origin without rail_origin.
#pragma once

#include "contactd/wheel_rail_setup.hpp"
#include "geometry/profile/curve_cotangent.hpp"

namespace contactd::geometry {

/// Adds the gradient by the origin of rail_origin to that by the curve. The top and the gauge point move with the
/// curve. With track.rail_origin, adds nothing.
void add_by_rail_origin(const Track& track, const ProfilePoint& by_origin, CurveCotangent& rail);

}  // namespace contactd::geometry
