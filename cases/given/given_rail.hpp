// The values that a wheel on a rail is made of, in mm, N, s, rad: those of a case of CONTACT, whoever set them.
#pragma once

#include <optional>
#include <vector>

#include "contactd/profile_spec.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd::cases {

struct GivenTrack {
    double gauge_height = 14;                       ///< not positive: the rail lies where it is told
    double gauge = 1435;                            ///< where the gauge height is positive
    double rail_y = 0, rail_z = 0;                  ///< elsewhere, of a right rail
    double cant = 0, roller_radius = 0;             ///< the radius is that of a roller
    double curvature = 0;                           ///< of the track (1/mm)
    double spring_y = 0, spring_z = 0;              ///< of a massless flexible rail (N/mm); 0: rigid
    double spring_force_y = 0, spring_force_z = 0;  ///< on it, beside those of the wheel (N)

    bool operator==(const GivenTrack&) const = default;
};

/// A profile, or the slices of one that varies.
struct GivenSurface {
    std::optional<ProfileSpec> profile{};
    std::vector<RailSlice> rail_slices{};
    std::vector<WheelSlice> wheel_slices{};
    SliceSpline spline = SliceSpline::cubic;

    bool empty() const { return !profile && rail_slices.empty() && wheel_slices.empty(); }
    bool operator==(const GivenSurface&) const = default;
};

/// Sizes of elements, and rules of patches (mm, rad).
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
    /// The first number is the speed forwards, or the pitch rate of a roller: what it is, the configuration tells.
    WheelsetVelocity velocity;
    double velocity_length = 1;  ///< unit of the first number as a speed (mm/s)
    WheelDeviation flexibility;
    std::optional<double> Fz{}, Fx{};  ///< (N), on the rail
    std::optional<GivenElements> elements{};
    double dq = 1;  ///< step of transient rolling, in elements
};

}  // namespace contactd::cases
