#include "kept_wheel.hpp"

#include "contactd/below.hpp"

namespace contactd::c {

bool serves(const WheelRailSetup& opened, const WheelRailSetup& wanted) {
    if (opened.friction && !wanted.friction) return false;
    if (opened.friction == wanted.friction) return opened == wanted;
    WheelRailSetup same = wanted;
    same.friction = opened.friction;
    return opened == same;
}

WheelRailStepInput step_of(const WheelRailSetup& opened, const WheelInput& wanted) {
    validate_below("state", wanted.state);
    WheelRailStepInput input{.state = wanted.state, .fields = wanted.fields, .gap = wanted.gap};
    if (opened.friction == wanted.setup.friction) return input;
    validate_below("setup", wanted.setup);
    input.friction = wanted.setup.friction;
    return input;
}

}  // namespace contactd::c
