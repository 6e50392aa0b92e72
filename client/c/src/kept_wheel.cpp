#include "kept_wheel.hpp"

#include <string>

#include "contactd/error.hpp"

namespace contactd::c {
namespace {

/// With the name that its field has where both are said.
template <class Part>
void validate_as(const std::string& name, const Part& part) {
    try {
        validate(part);
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(name + error.field(), std::string(error.what()).substr(error.field().size() + 1));
    }
}

}  // namespace

bool serves(const WheelRailSetup& opened, const WheelRailSetup& wanted) {
    if (opened.friction && !wanted.friction) return false;
    if (opened.friction == wanted.friction) return opened == wanted;
    WheelRailSetup same = wanted;
    same.friction = opened.friction;
    return opened == same;
}

WheelRailStepInput step_of(const WheelRailSetup& opened, const WheelInput& wanted) {
    validate_as("state.", wanted.state);
    WheelRailStepInput input{.state = wanted.state, .fields = wanted.fields, .gap = wanted.gap};
    if (opened.friction == wanted.setup.friction) return input;
    validate_as("setup.", wanted.setup);
    input.friction = wanted.setup.friction;
    return input;
}

}  // namespace contactd::c
