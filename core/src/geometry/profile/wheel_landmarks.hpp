// Places by which a wheel is known.
#pragma once

#include <optional>

#include "contactd/profile.hpp"
#include "contactd/profile_evidence.hpp"

namespace contactd::geometry {

/// Tip, throat and tread of a wheel whose flange stands out by 10 mm at least; nothing of others. The curve's y
/// ascends, z points downwards.
std::optional<WheelLandmarks> wheel_landmarks(const ProfileCurve& wheel);

}  // namespace contactd::geometry
