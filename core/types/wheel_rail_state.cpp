#include "contactd/wheel_rail_state.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "number_text.hpp"

namespace contactd {
namespace {

constexpr double least_vertical = 1e-6;  // N; produces an approach of 1e-8 mm

void check_vertical(double force, const std::string& field) {
    if (!(force > 0 && std::isfinite(force)))
        throw InvalidArgument(field, "is " + number_text(force) + "; it must be positive (N)");
    if (force < least_vertical)
        throw InvalidArgument(field, "is " + number_text(force) + "; it must be at least " +
                                         number_text(least_vertical) +
                                         " N, because a smaller force does not change the height within its precision");
}

WheelRailState state_of_wheel(const WheelsetState& state, const WheelDeviation& wheel, const RailDeviation& rail,
                              double Fz) {
    WheelRailState one{state.position, state.velocity, wheel, rail, state.roller_pitch};
    one.Fz = Fz;
    return one;
}

void check_rail_load(double force, const std::optional<double>& spring, const std::string& direction) {
    if (force != 0 && !spring)
        throw InvalidArgument("rail.F" + direction,
                              "is " + number_text(force) +
                                  ", but the rail is rigid in that direction; set track.springs." + direction +
                                  " of the set-up or remove the force");
}

void check_motion(const WheelRailSetup& setup, WheelRailMotion motion) {
    if (motion == WheelRailMotion::steady_rolling) return;
    const auto refuse = [](const std::string& reason) {
        throw InvalidArgument("motion", "is not steady_rolling, but " + reason);
    };
    if (setup.model != Model::full)
        refuse("simplified models solve steady rolling only; set model = full in the set-up");
    for (const auto& [given, name] :
         {std::pair(setup.temperature.has_value(), "temperature"), std::pair(setup.fatigue.has_value(), "fatigue"),
          std::pair(setup.wear.has_value(), "wear")})
        if (given)
            refuse(std::string(name) + " of the set-up requires it; set motion = steady_rolling or remove " + name);
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
        throw InvalidArgument("time_step", "is missing; a shift is the product of the velocities and this time (s)");
    if (state.motion == WheelRailMotion::steady_rolling && state.time_step)
        throw InvalidArgument(
            "time_step",
            "is " + number_text(*state.time_step) +
                ", but steady rolling has no steps; remove it, or set motion to transient_rolling or shift");
    if (state.Fx && state.velocity.x == 0 && state.roller_pitch == 0)
        throw InvalidArgument(
            "Fx",
            "is given, but velocity.x and roller_pitch are 0; a wheel at rest has no pitch rate that produces a force");
}

void validate(const WheelRailSetup& setup, const WheelRailState& state) {
    validate(state);
    if (state.Fx && !setup.friction)
        throw InvalidArgument("Fx", "requires friction; set friction in the set-up or remove Fx");
    const RailSprings springs = setup.track.springs.value_or(RailSprings{});
    check_rail_load(state.rail.Fy, springs.y, "y");
    check_rail_load(state.rail.Fz, springs.z, "z");
    check_motion(setup, state.motion);
}

void check_height_or_force(const WheelRailState& state) {
    if (!state.Fz && !state.position.z)
        throw InvalidArgument(
            "Fz", "is missing, and so is position.z; give the vertical force Fz (N), or the height position.z (mm)");
}

void validate(const WheelsetState& state) {
    check_vertical(state.Fz_left, "Fz_left");
    check_vertical(state.Fz_right, "Fz_right");
    check_bounds(state);
}

}  // namespace contactd
