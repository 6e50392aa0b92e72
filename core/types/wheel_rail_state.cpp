#include "contactd/wheel_rail_state.hpp"

#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "number_text.hpp"

namespace contactd {
namespace {

// Beyond these a value has another unit, or is a mistake.
constexpr double largest_length = 1e4;    // mm
constexpr double largest_angle = 0.5;     // rad
constexpr double largest_velocity = 1e9;  // mm/s, rad/s
constexpr double largest_force = 1e9;     // N
constexpr double least_vertical = 1e-6;   // N: brings an approach of 1e-8 mm

void check(double value, double largest, const std::string& field, const char* unit) {
    if (!(std::abs(value) <= largest))
        throw InvalidArgument(field, "is " + number_text(value) + "; it must lie in [-" + number_text(largest) + ", " +
                                         number_text(largest) + "] " + unit);
}

void check_motion(const WheelsetPosition& position, const WheelsetVelocity& velocity, double roller_pitch) {
    check(position.x, 1e9, "position.x", "mm");
    check(position.pitch, 1e9, "position.pitch", "rad");
    check(position.y, largest_length, "position.y", "mm");
    check(position.z, largest_length, "position.z", "mm");
    check(position.roll, largest_angle, "position.roll", "rad");
    check(position.yaw, largest_angle, "position.yaw", "rad");
    check(velocity.x, largest_velocity, "velocity.x", "mm/s");
    check(velocity.y, largest_velocity, "velocity.y", "mm/s");
    check(velocity.z, largest_velocity, "velocity.z", "mm/s");
    check(velocity.roll, largest_velocity, "velocity.roll", "rad/s");
    check(velocity.yaw, largest_velocity, "velocity.yaw", "rad/s");
    check(velocity.pitch, largest_velocity, "velocity.pitch", "rad/s");
    check(roller_pitch, largest_velocity, "roller_pitch", "rad/s");
}

void check_rail(const RailDeviation& rail, const std::string& name) {
    check(rail.y, largest_length, name + ".y", "mm");
    check(rail.z, largest_length, name + ".z", "mm");
    check(rail.roll, largest_angle, name + ".roll", "rad");
    check(rail.y_velocity, largest_velocity, name + ".y_velocity", "mm/s");
    check(rail.z_velocity, largest_velocity, name + ".z_velocity", "mm/s");
    check(rail.roll_velocity, largest_velocity, name + ".roll_velocity", "rad/s");
    check(rail.Fy, largest_force, name + ".Fy", "N");
    check(rail.Fz, largest_force, name + ".Fz", "N");
}

void check_vertical(double force, const std::string& field) {
    if (!(force > 0 && std::isfinite(force)))
        throw InvalidArgument(field,
                              "is " + number_text(force) + "; a wheel presses on its rail with a positive force (N)");
    if (force < least_vertical)
        throw InvalidArgument(field, "is " + number_text(force) + "; a wheel presses on its rail with " +
                                         number_text(least_vertical) +
                                         " N at least, for heights have no digits that less would change");
}

WheelRailState state_of_wheel(const WheelsetState& state, const RailDeviation& rail, double Fz) {
    WheelRailState wheel{state.position, state.velocity, rail, state.roller_pitch};
    wheel.Fz = Fz;
    return wheel;
}

}  // namespace

WheelRailState state_of_right_wheel(const WheelsetState& state) {
    return state_of_wheel(state, state.right_rail, state.Fz_right);
}

WheelRailState state_of_left_wheel(const WheelsetState& state) {
    return state_of_wheel(state, state.left_rail, state.Fz_left);
}

void validate(const WheelRailState& state) {
    const auto& [position, velocity, rail, roller_pitch, Fz, Fx, derivatives] = state;
    check_motion(position, velocity, roller_pitch);
    check_rail(rail, "rail");
    if (Fz) check_vertical(*Fz, "Fz");
    if (Fx && !std::isfinite(*Fx)) throw InvalidArgument("Fx", "is " + number_text(*Fx) + "; it must be a force (N)");
    if (Fx && velocity.x == 0 && roller_pitch == 0)
        throw InvalidArgument("Fx",
                              "is given, and velocity.x and roller_pitch are 0; a wheel that stands has no pitch "
                              "rate that brings a force");
}

void validate(const WheelsetState& state) {
    check_motion(state.position, state.velocity, state.roller_pitch);
    check_rail(state.left_rail, "left_rail");
    check_rail(state.right_rail, "right_rail");
    check_vertical(state.Fz_left, "Fz_left");
    check_vertical(state.Fz_right, "Fz_right");
}

}  // namespace contactd
