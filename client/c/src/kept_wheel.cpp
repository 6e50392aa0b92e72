#include "kept_wheel.hpp"

#include <string>

#include "contactd/error.hpp"

namespace contactd::c {

bool serves(const WheelRailSetup& opened, const WheelRailSetup& wanted) {
    if (opened.friction && !wanted.friction) return false;
    if (opened.friction == wanted.friction) return opened == wanted;
    WheelRailSetup same = wanted;
    same.friction = opened.friction;
    return opened == same;
}

WheelRailStepInput step_of(const WheelRailSetup& opened, const WheelInput& wanted) {
    WheelRailStepInput input{.state = wanted.state, .fields = wanted.fields, .gap = wanted.gap};
    if (opened.friction == wanted.setup.friction) return input;
    try {
        validate(wanted.setup);
    } catch (const InvalidArgument& error) {
        throw InvalidArgument("setup." + error.field(), std::string(error.what()).substr(error.field().size() + 1));
    }
    input.friction = wanted.setup.friction;
    return input;
}

}  // namespace contactd::c
