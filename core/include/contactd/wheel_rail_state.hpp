// Inputs of a step of a wheel on a rail: position and motion of the wheelset.
#pragma once

#include <optional>

namespace contactd {

/// Position of the wheelset's centre in track coordinates: y and z (mm) from where it stands in the middle with its
/// tape circles on the plane of the track. Angles (rad) turn from y to z (roll), z to x (pitch) and x to y (yaw), the
/// yaw first.
struct WheelsetPosition {
    double y = 0;
    std::optional<double> z{};  ///< absent where a force is given in its place; searches then begin at 0
    double roll = 0, yaw = 0;
    double x = 0;      ///< along the track (mm), where the rail varies; forces and references are told from there on
    double pitch = 0;  ///< rotation about its axle (rad), for an out-of-round wheel; any number of revolutions

    double height() const { return z.value_or(0); }
    bool operator==(const WheelsetPosition&) const = default;
};

/// Velocity of the wheelset's centre (mm/s, along x, y and z of the track) and about its own axes (rad/s): a wheelset
/// that rolls forwards has a pitch rate near -x/nominal_radius.
struct WheelsetVelocity {
    double x = 0, y = 0, z = 0, roll = 0, yaw = 0, pitch = 0;

    bool operator==(const WheelsetVelocity&) const = default;
};

/// Deviation of the rail from where track and gauge have it, in track coordinates also for a left rail (mm, rad, mm/s,
/// rad/s).
struct RailDeviation {
    double y = 0, z = 0, roll = 0;
    double y_velocity = 0, z_velocity = 0, roll_velocity = 0;
    double Fy = 0, Fz = 0;  ///< on a flexible rail, in addition to those of wheel and springs (N)

    bool operator==(const RailDeviation&) const = default;
};

/// Deviation of the wheel from where a rigid wheelset has it, as of an axle that bends: of the origin of its profile
/// along the wheelset's axes (mm), and turns about that point (rad), the yaw first. Rates are added to the motion of
/// the wheelset (mm/s, rad/s).
struct WheelDeviation {
    double x = 0, y = 0, z = 0, roll = 0, yaw = 0;
    double pitch = 0;  ///< of an out-of-round wheel
    double x_velocity = 0, y_velocity = 0, z_velocity = 0;
    double roll_velocity = 0, yaw_velocity = 0, pitch_velocity = 0;

    bool operator==(const WheelDeviation&) const = default;
};

/// What a step is: steady rolling knows nothing of the steps before; transient rolling and a shift go on from the
/// tractions that the last one ended with. Elements of transient rolling move with the wheelset, and those of a shift
/// are fixed to the rail.
enum class WheelRailMotion { steady_rolling, transient_rolling, shift };

struct WheelRailState {
    WheelsetPosition position{};
    WheelsetVelocity velocity{};
    WheelDeviation wheel{};
    RailDeviation rail{};
    double roller_pitch =
        0;  ///< pitch rate of a roller (rad/s): > 0 where the wheel on it turns as when rolling forwards
    /// Vertical force of this wheel on the rail (N, 1e-6 at least), which position.z is found for; its value then only
    /// tells where to start. Absent: position.z is prescribed. A solve needs one of them.
    std::optional<double> Fz{};
    /// Longitudinal force on the rail (N), along the wheelset's x axis, which velocity.pitch is found for; its value
    /// then means nothing. Needs friction.
    std::optional<double> Fx{};
    WheelRailMotion motion = WheelRailMotion::steady_rolling;
    /// Duration of a step that is not steady (s): a shift is that of the velocities in this time, and transient rolling
    /// goes as far as the rolling velocity takes it. Absent, that rolls by the step of the set-up, dq.
    std::optional<double> time_step{};
    bool derivatives = false;    ///< whether the solution has those
    bool displacements = false;  ///< whether the solutions of its patches have those

    bool operator==(const WheelRailState&) const = default;
};

/// Both wheels, each under a vertical force of its own: position.z and position.roll are found for them, and their
/// values tell where to start.
struct WheelsetState {
    WheelsetPosition position{};
    WheelsetVelocity velocity{};
    WheelDeviation left_wheel{}, right_wheel{};
    RailDeviation left_rail{}, right_rail{};
    double roller_pitch = 0;           ///< as in WheelRailState
    double Fz_left = 0, Fz_right = 0;  ///< on the rails (N), 1e-6 at least

    bool operator==(const WheelsetState&) const = default;
};

/// State of one of its wheels, by the position and the force that the wheelset states.
WheelRailState state_of_right_wheel(const WheelsetState& state);
WheelRailState state_of_left_wheel(const WheelsetState& state);

/// Throws InvalidArgument naming the field, e.g. "position.roll".
void validate(const WheelRailState& state);
/// Throws InvalidArgument ("Fz") for a state that has neither Fz nor position.z, at which no contact can be solved.
void check_height_or_force(const WheelRailState& state);
/// Throws InvalidArgument naming the field, e.g. "left_rail.y", "Fz_right".
void validate(const WheelsetState& state);

}  // namespace contactd
