// The equivalent conicity of a wheelset that has the wheel and the rail of a set-up on both sides.
#pragma once

#include <vector>

#include "contactd/conicity.hpp"
#include "contactd/observer.hpp"
#include "contactd/wheel_rail_setup.hpp"

namespace contactd::engine {

/// Throws InvalidArgument naming "setup.rail.points", "conicity.amplitudes[i]", ..., and Cancelled.
std::vector<EquivalentConicity> wheelset_conicities(const WheelRailSetup& setup, const ConicityRequest& wanted,
                                                    const Observer& observer);

}  // namespace contactd::engine
