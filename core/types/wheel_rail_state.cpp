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

void check(double value, double largest, const std::string& field, const char* unit) {
    if (!(std::abs(value) <= largest))
        throw InvalidArgument(field, "is " + number_text(value) + "; it must lie in [-" + number_text(largest) + ", " +
                                         number_text(largest) + "] " + unit);
}

}  // namespace

void validate(const WheelRailState& state) {
    const auto& [position, velocity, rail, roller_pitch, Fz, Fx, derivatives] = state;
    check(position.x, 1e9, "position.x", "mm");
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
    check(rail.y, largest_length, "rail.y", "mm");
    check(rail.z, largest_length, "rail.z", "mm");
    check(rail.roll, largest_angle, "rail.roll", "rad");
    check(rail.y_velocity, largest_velocity, "rail.y_velocity", "mm/s");
    check(rail.z_velocity, largest_velocity, "rail.z_velocity", "mm/s");
    check(rail.roll_velocity, largest_velocity, "rail.roll_velocity", "rad/s");
    check(roller_pitch, largest_velocity, "roller_pitch", "rad/s");
    if (Fz && !(*Fz > 0 && std::isfinite(*Fz)))
        throw InvalidArgument("Fz",
                              "is " + number_text(*Fz) + "; a wheel presses on its rail with a positive force (N)");
    if (Fx && !std::isfinite(*Fx)) throw InvalidArgument("Fx", "is " + number_text(*Fx) + "; it must be a force (N)");
    if (Fx && velocity.x == 0 && roller_pitch == 0)
        throw InvalidArgument("Fx",
                              "is given, and velocity.x and roller_pitch are 0; a wheel that stands has no pitch "
                              "rate that brings a force");
}

}  // namespace contactd
