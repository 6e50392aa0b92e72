// Keeps wheels with an unchanged set-up, so that a solve only contains their state.
#pragma once

#include "backend.hpp"

namespace contactd::c {

/// Returns whether steps of a wheel opened with `opened` support the request; they can change the friction.
bool serves(const WheelRailSetup& opened, const WheelRailSetup& requested);

/// Returns the inputs of such a step. Throws InvalidArgument ("state.position.roll", "setup.friction.mu", ...).
WheelRailStepInput step_of(const WheelRailSetup& opened, const WheelInput& requested);

}  // namespace contactd::c
