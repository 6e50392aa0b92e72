#include "wheel_cache.hpp"

#include "contactd/below.hpp"

namespace contactd::c {

bool serves(const WheelRailSetup& opened, const WheelRailSetup& requested) {
    if (opened.friction && !requested.friction) return false;
    if (opened.friction == requested.friction) return opened == requested;
    WheelRailSetup same = requested;
    same.friction = opened.friction;
    return opened == same;
}

WheelRailStepInput step_of(const WheelRailSetup& opened, const WheelInput& requested) {
    below("state", [&] { validate(requested.setup, requested.state); });
    WheelRailStepInput input{.state = requested.state, .fields = requested.fields, .gap = requested.gap};
    if (opened.friction == requested.setup.friction) return input;
    validate_below("setup", requested.setup);
    input.friction = requested.setup.friction;
    return input;
}

}  // namespace contactd::c
