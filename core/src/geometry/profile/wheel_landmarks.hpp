// Finds characteristic points of a wheel.
#pragma once

#include <optional>

#include "contactd/profile.hpp"
#include "contactd/profile_evidence.hpp"

namespace contactd::geometry {

/// Returns tip, throat and tread of a wheel whose flange is at least 10 mm high, and nothing for others. The curve's y
/// ascends, and z points downwards.
std::optional<WheelLandmarks> wheel_landmarks(const ProfileCurve& wheel);

}  // namespace contactd::geometry
