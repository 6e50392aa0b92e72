// Defines set-ups and states on a massless flexible rail.
#pragma once

#include <optional>

#include "contactd/observer.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "wheel_rail/position/height_search.hpp"

namespace contactd {

class RightWheel;

inline constexpr double deepest_penetration = 5;  ///< wheel in its rail (mm): more than any elastic penetration

/// Returns the state with the rail fixed in its deflected position, the wheel at its height or under its force, and the
/// same pitch rate.
WheelRailState deflected(WheelRailState state, const RailDeflection& deflection);

/// Returns the search for the height over the rail of a wheel with a prescribed height in the track, at which contact
/// and spring carry the same force. `unloaded` is the wheel on a rail without vertical deflection. Returns nothing if
/// the wheel is above that rail.
std::optional<HeightTask> height_over_rail(RightWheel& unloaded, const WheelRailState& given, double stiffness);

/// Sets the derivatives of the solution of a wheel on a flexible rail, including its deflection, or adds a warning if
/// there are none.
void differentiate_on_flexible_rail(const RightWheel& wheel, WheelRailSolution& solution, Observer& observer);

/// Returns the pitch rate of a wheel that rolls without creepage at its nominal radius (rad/s).
double rolling_pitch_rate(const WheelRailSetup& setup, const WheelRailState& state);

/// Returns the set-up with the rail fixed in its position.
WheelRailSetup with_fixed_rail(WheelRailSetup setup);
/// Returns the state with the rail fixed in its position estimated without a solve: laterally from the external forces,
/// vertically also from the wheel's force.
WheelRailState expected_on_flexible_rail(const RightWheel& wheel);

}  // namespace contactd
