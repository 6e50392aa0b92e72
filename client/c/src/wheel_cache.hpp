// Wheels whose set-up stays from solve to solve, so that a solve states only where they are.
#pragma once

#include "backend.hpp"

namespace contactd::c {

/// Whether steps of a wheel that was opened with `opened` can say what is asked; they can name another friction.
bool serves(const WheelRailSetup& opened, const WheelRailSetup& requested);

/// Returns the inputs of a step of it. Throws InvalidArgument ("state.position.roll", "setup.friction.mu", ...).
WheelRailStepInput step_of(const WheelRailSetup& opened, const WheelInput& requested);

}  // namespace contactd::c
