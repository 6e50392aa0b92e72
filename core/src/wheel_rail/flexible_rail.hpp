// A massless flexible rail, which deflects: set-ups and states on it.
#pragma once

#include <optional>

#include "contactd/observer.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "wheel_rail/position/height_search.hpp"

namespace contactd {

class RightWheel;

inline constexpr double deepest_penetration = 5;  ///< of a wheel in its rail (mm): deeper than anything elastic

/// Returns the state with the rail deflected and fixed there, the wheel at its height or under its force, the pitch
/// rate as it is.
WheelRailState deflected(WheelRailState state, const RailDeflection& deflection);

/// Returns the search for the height over the rail of a wheel at its height in the track: where the rail carries what
/// its spring then does. `unloaded` is the wheel with a rail not deflected vertically. None where it hangs above that.
std::optional<HeightTask> height_over_rail(RightWheel& unloaded, const WheelRailState& given, double stiffness);

/// Sets the derivatives of the solution of a wheel on a flexible rail, in which the rail deflects, or says in a warning
/// why there are none.
void differentiate_on_flexible_rail(const RightWheel& wheel, WheelRailSolution& solution, Observer& observer);

/// Returns the pitch rate of a wheel that rolls without creepage at its nominal radius (rad/s).
double rolling_pitch_rate(const WheelRailSetup& setup, const WheelRailState& state);

/// Returns the set-up with the rail fixed where it is.
WheelRailSetup with_fixed_rail(WheelRailSetup setup);
/// Returns the state with the rail fixed where it is expected without a solve: laterally by the forces besides the
/// wheel's, vertically also by the wheel's force.
WheelRailState expected_on_flexible_rail(const RightWheel& wheel);

}  // namespace contactd
