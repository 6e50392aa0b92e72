// Solves both wheels of a wheelset at once: combines their inputs, and gives each its part of the answer.
#include "wheel.hpp"

#include <algorithm>
#include <stop_token>
#include <string>
#include <utility>

namespace contactd::c {
namespace {

[[noreturn]] void differ(const char* field) {
    throw InvalidArgument(field, "differs between the wheels, but a wheelset has only one: set the same for both");
}

/// z and roll are computed; their inputs are only initial values.
void check_same_motion(const WheelRailState& right, const WheelRailState& left) {
    WheelsetPosition position = left.position;
    position.z = right.position.z;
    position.roll = right.position.roll;
    if (position != right.position) differ("state.position");
    if (left.velocity != right.velocity) differ("state.velocity");
    if (left.roller_pitch != right.roller_pitch) differ("state.roller_pitch");
}

double vertical_force(const WheelRailState& state, const char* field) {
    if (!state.Fz) throw InvalidArgument(field, "is missing; set \"state.Fz\" of each wheel with contactd_set");
    return *state.Fz;
}

void check_side(const WheelInput& wheel, Side side, const char* which) {
    if (wheel.setup.side != side)
        throw InvalidArgument("setup.side",
                              std::string("is wrong for the ") + which + " wheel; set it with contactd_set_word");
}

void check_no_more(const WheelRailState& state) {
    if (state.Fx)
        throw InvalidArgument("state.Fx",
                              "is given, but the pitch rate of a wheelset is prescribed, not found: remove it");
    if (state.motion != WheelRailMotion::steady_rolling)
        throw InvalidArgument("state.motion",
                              "is not steady_rolling, the only motion that a wheelset free to roll supports");
    if (state.derivatives)
        throw InvalidArgument("state.derivatives", "is requested, but the answer for a wheelset has no derivatives");
}

SolutionFields all_of(const SolutionFields& some, const SolutionFields& others) {
    SolutionFields fields = some;
    for (const SolutionField field : others)
        if (std::ranges::find(fields, field) == fields.end()) fields.push_back(field);
    return fields;
}

WheelsetInput put_together(const WheelInput& right, const WheelInput& left) {
    check_side(right, Side::right, "right");
    check_side(left, Side::left, "left");
    for (const WheelInput* wheel : {&right, &left}) check_no_more(wheel->state);
    check_same_motion(right.state, left.state);
    return {{right.setup, left.setup},
            {right.state.position, right.state.velocity, left.state.wheel, right.state.wheel, left.state.rail,
             right.state.rail, right.state.roller_pitch, vertical_force(left.state, "state.Fz_left"),
             vertical_force(right.state, "state.Fz_right")},
            all_of(right.fields, left.fields),
            right.gap || left.gap};
}

}  // namespace

void Wheel::solve_wheelset(Wheel& right, Wheel& left) {
    if (right.backend_ != left.backend_)
        throw InvalidArgument("left", "belongs to a different connection than the right wheel");
    const WheelsetInput input = put_together(right.inputs, left.inputs);
    if (!right.open_) right.open_ = right.backend_->open_wheel(right.settings_);
    WheelsetSolution solution = left.controlled([&](const Control& of_left) {
        return right.controlled([&](Control& control) {
            std::stop_source either;
            const auto stop = [&either] { either.request_stop(); };
            const std::stop_callback by_left(of_left.stop, stop), by_right(control.stop, stop);
            control.stop = either.get_token();
            control.timeout = right.effective_timeout();
            return right.open_->solve_wheelset(input, control);
        });
    });
    const auto give = [&](Wheel& wheel, WheelRailSolution& part) {
        part.warnings.insert(part.warnings.end(), solution.warnings.begin(), solution.warnings.end());
        wheel.take({std::move(part), wheel.inputs.fields, wheel.inputs.gap, solution.roll, solution.roll_search});
    };
    give(right, solution.right);
    give(left, solution.left);
}

}  // namespace contactd::c
