// Holds the values of a case of CONTACT for a wheel on a rail, from a file or from a program, in mm, N, s and rad.
#pragma once

#include <optional>
#include <vector>

#include "contactd/profile_spec.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd::cases {

struct GivenTrack {
    double gauge_height = 14;                       ///< if it is not positive, rail_y and rail_z place the rail
    double gauge = 1435;                            ///< used if the gauge height is positive
    double rail_y = 0, rail_z = 0;                  ///< position of a right rail without a gauge height
    double cant = 0, roller_radius = 0;             ///< the radius is only used for rollers
    double curvature = 0;                           ///< of the track (1/mm)
    double spring_y = 0, spring_z = 0;              ///< stiffness of a massless flexible rail (N/mm); 0 if rigid
    double spring_force_y = 0, spring_force_z = 0;  ///< forces on it in addition to those of the wheel (N)

    bool operator==(const GivenTrack&) const = default;
};

/// Holds a profile, or the slices of a varying profile.
struct GivenSurface {
    std::optional<ProfileSpec> profile{};
    std::vector<RailSlice> rail_slices{};
    std::vector<WheelSlice> wheel_slices{};
    SliceSpline spline = SliceSpline::cubic;

    bool empty() const { return !profile && rail_slices.empty() && wheel_slices.empty(); }
    bool operator==(const GivenSurface&) const = default;
};

/// Holds element sizes and rules of patches (mm, rad).
struct GivenElements {
    double dx = 0, ds = 0;
    double angle_separate = 1.5707963267948966;
    double separate = 8, combine = 4, turn = 12;
};

struct GivenRail {
    GivenSurface rail, wheel;
    GivenTrack track;
    Wheelset wheelset;
    RailDeviation deviation;  ///< without forces
    WheelsetPosition position;
    /// The first number is the forward speed, or the pitch rate of a roller, depending on the configuration C1.
    WheelsetVelocity velocity;
    double velocity_length = 1;  ///< unit of the first number if it is a speed (mm/s)
    WheelDeviation flexibility;
    std::optional<double> Fz{}, Fx{};  ///< forces on the rail (N)
    std::optional<GivenElements> elements{};
    double dq = 1;  ///< step of transient rolling, in elements
};

}  // namespace contactd::cases
