// Defines the inputs of a step of a wheel on a rail: position and motion of the wheelset.
#pragma once

#include <optional>

namespace contactd {

struct WheelRailSetup;

/// Describes the position of the wheelset's centre in track coordinates: y and z (mm) are relative to the central
/// position with its tape circles on the plane of the track. Angles (rad) rotate from y to z (roll), z to x (pitch) and
/// x to y (yaw), the yaw first.
struct WheelsetPosition {
    double y = 0;
    std::optional<double> z{};  ///< absent if a force is prescribed instead; searches then start at 0
    double roll = 0, yaw = 0;
    double x = 0;      ///< along the track (mm), for a rail that varies; forces and references are relative to it
    double pitch = 0;  ///< rotation about its axle (rad), for an out-of-round wheel; any number of revolutions

    double height() const { return z.value_or(0); }
    bool operator==(const WheelsetPosition&) const = default;
};

/// Describes the velocity of the wheelset's centre (mm/s, along x, y and z of the track) and about its own axes
/// (rad/s). A wheelset that rolls forward has a pitch rate near -x/nominal_radius.
struct WheelsetVelocity {
    double x = 0, y = 0, z = 0, roll = 0, yaw = 0, pitch = 0;

    bool operator==(const WheelsetVelocity&) const = default;
};

/// Describes the deviation of the rail from its place by track and gauge, in track coordinates, also for a left rail
/// (mm, rad, mm/s, rad/s).
struct RailDeviation {
    double y = 0, z = 0, roll = 0;
    double y_velocity = 0, z_velocity = 0, roll_velocity = 0;
    double Fy = 0, Fz = 0;  ///< on a flexible rail, in addition to those of wheel and springs (N)

    bool operator==(const RailDeviation&) const = default;
};

/// Describes the deviation of the wheel from its place on a rigid wheelset, for example due to axle bending:
/// displacement of the origin of its profile along the wheelset's axes (mm), and rotation about that point (rad), yaw
/// first. Rates are added to the motion of the wheelset (mm/s, rad/s).
struct WheelDeviation {
    double x = 0, y = 0, z = 0, roll = 0, yaw = 0;
    double pitch = 0;  ///< for an out-of-round wheel
    double x_velocity = 0, y_velocity = 0, z_velocity = 0;
    double roll_velocity = 0, yaw_velocity = 0, pitch_velocity = 0;

    bool operator==(const WheelDeviation&) const = default;
};

/// Selects the kind of step. Steady rolling does not depend on the previous steps. Transient rolling and a shift start
/// from the tractions at the end of the previous step. Elements of transient rolling move with the wheelset; those of a
/// shift are fixed to the rail.
enum class WheelRailMotion { steady_rolling, transient_rolling, shift };

struct WheelRailState {
    WheelsetPosition position{};
    WheelsetVelocity velocity{};
    WheelDeviation wheel{};
    RailDeviation rail{};
    double roller_pitch = 0;  ///< pitch rate of a roller (rad/s), > 0 if the wheel on it turns as in forward rolling
    /// The wheel's vertical force on the rail (N, at least 1e-6) determines position.z, whose value is then the start
    /// of the search. If it is absent, position.z is prescribed. A solve requires one of them.
    std::optional<double> Fz{};
    /// The longitudinal force on the rail (N), along the wheelset's x axis, determines velocity.pitch, whose value is
    /// then ignored. It requires friction.
    std::optional<double> Fx{};
    WheelRailMotion motion = WheelRailMotion::steady_rolling;
    /// A step that is not steady has this duration (s). A shift has the velocities for this time, and transient rolling
    /// covers the distance of the rolling velocity. If absent, transient rolling covers dq of the set-up.
    std::optional<double> time_step{};
    bool derivatives = false;    ///< whether the solution includes derivatives
    bool displacements = false;  ///< whether the patches include displacements

    bool operator==(const WheelRailState&) const = default;
};

/// Describes both wheels, each under its own vertical force. position.z and position.roll are computed; their values
/// are the start of the search.
struct WheelsetState {
    WheelsetPosition position{};
    WheelsetVelocity velocity{};
    WheelDeviation left_wheel{}, right_wheel{};
    RailDeviation left_rail{}, right_rail{};
    double roller_pitch = 0;           ///< as in WheelRailState
    double Fz_left = 0, Fz_right = 0;  ///< on the rails (N), at least 1e-6

    bool operator==(const WheelsetState&) const = default;
};

/// Return the state of one wheel, with the position and the force of the wheelset.
WheelRailState state_of_right_wheel(const WheelsetState& state);
WheelRailState state_of_left_wheel(const WheelsetState& state);

/// Throws InvalidArgument, which names the field, e.g. "position.roll".
void validate(const WheelRailState& state);
/// Also throws InvalidArgument for a field of the state that the set-up does not allow, e.g. "Fx" without friction,
/// "rail.Fy" on a rail without that spring, or "motion" with temperatures. Call it before any contact is prepared.
void validate(const WheelRailSetup& setup, const WheelRailState& state);
/// Throws InvalidArgument ("Fz") for a state that has neither Fz nor position.z, at which no contact can be solved.
void check_height_or_force(const WheelRailState& state);
/// Throws InvalidArgument, which names the field, e.g. "left_rail.y", "Fz_right".
void validate(const WheelsetState& state);

}  // namespace contactd
