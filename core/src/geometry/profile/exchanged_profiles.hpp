// Recognizes profiles of wheel and rail that are exchanged.
#pragma once

#include "contactd/profile.hpp"

namespace contactd::geometry {

/// Returns whether the profile of a rail has the shape of a wheel: a narrow flange that points upwards, and a wide
/// tread beside it. y ascends, z points downwards.
bool has_shape_of_wheel(const ProfileCurve& rail);

/// Returns whether the profile of a wheel has the shape of a rail's head that hangs downwards, with steep sides.
bool has_shape_of_rail(const ProfileCurve& wheel);

}  // namespace contactd::geometry
