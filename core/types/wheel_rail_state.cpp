#include "contactd/wheel_rail_state.hpp"

#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "number_text.hpp"

namespace contactd {
namespace {

constexpr double least_vertical = 1e-6;  // N: brings an approach of 1e-8 mm

void check_vertical(double force, const std::string& field) {
    if (!(force > 0 && std::isfinite(force)))
        throw InvalidArgument(field,
                              "is " + number_text(force) + "; a wheel presses on its rail with a positive force (N)");
    if (force < least_vertical)
        throw InvalidArgument(field, "is " + number_text(force) + "; a wheel presses on its rail with " +
                                         number_text(least_vertical) +
                                         " N at least, for heights have no digits that less would change");
}

WheelRailState state_of_wheel(const WheelsetState& state, const WheelDeviation& wheel, const RailDeviation& rail,
                              double Fz) {
    WheelRailState one{state.position, state.velocity, wheel, rail, state.roller_pitch};
    one.Fz = Fz;
    return one;
}

}  // namespace

WheelRailState state_of_right_wheel(const WheelsetState& state) {
    return state_of_wheel(state, state.right_wheel, state.right_rail, state.Fz_right);
}

WheelRailState state_of_left_wheel(const WheelsetState& state) {
    return state_of_wheel(state, state.left_wheel, state.left_rail, state.Fz_left);
}

void validate(const WheelRailState& state) {
    if (state.Fz) check_vertical(*state.Fz, "Fz");
    check_bounds(state);
    if (state.motion == WheelRailMotion::shift && !state.time_step)
        throw InvalidArgument("time_step", "is missing; a shift is what the velocities bring in that time (s)");
    if (state.motion == WheelRailMotion::steady_rolling && state.time_step)
        throw InvalidArgument("time_step", "is " + number_text(*state.time_step) +
                                               ", and steady rolling has no steps; leave it out, or give motion "
                                               "transient_rolling or shift");
    if (state.Fx && state.velocity.x == 0 && state.roller_pitch == 0)
        throw InvalidArgument("Fx",
                              "is given, and velocity.x and roller_pitch are 0; a wheel that stands has no pitch "
                              "rate that brings a force");
}

void check_height_or_force(const WheelRailState& state) {
    if (!state.Fz && !state.position.z)
        throw InvalidArgument("Fz",
                              "is missing, and so is position.z; give the vertical force Fz (N), which the height is "
                              "found for, or the height position.z (mm)");
}

void validate(const WheelsetState& state) {
    check_vertical(state.Fz_left, "Fz_left");
    check_vertical(state.Fz_right, "Fz_right");
    check_bounds(state);
}

}  // namespace contactd
