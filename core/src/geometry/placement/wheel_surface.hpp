// Represents a right wheel in track coordinates: a surface of revolution, or an out-of-round one, about the wheelset's
// axle, or about the bent axle of a flexible wheelset.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "contactd/profile.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/out_of_round.hpp"
#include "geometry/placement/span.hpp"
#include "geometry/placement/vector3.hpp"

namespace contactd::geometry {

/// Describes a point of the wheel with the least distance to the rail along the track.
struct LocusPoint {
    Vector3 at;     ///< in track coordinates
    Vector3 slope;  ///< derivative of `at` by s; on a rail that varies along the track as if x were constant nearby
};

/// Describes a point of the lower half, at an x of the wheel's own axes and an s of the profile, by its distance below
/// the axle (mm). The derivatives of that distance are by_x / over by x, and by_s / over by s.
struct BelowAxle {
    double z = 0;
    double by_x = 0, by_s = 0, over = 1;
};

class WheelSurface {
   public:
    /// `out_of_round` is the deviation of an out-of-round wheel from its profile.
    WheelSurface(ProfileCurve profile, const Wheelset& wheelset, const WheelsetPosition& position,
                 const WheelDeviation& deviation = {}, std::shared_ptr<const OutOfRound> out_of_round = nullptr);

    bool is_round() const { return !out_of_round_; }
    /// Returns the largest increase of an out-of-round wheel's radius with the angle, over the radius.
    double steepest() const { return out_of_round_ ? out_of_round_->steepest() / radius_ : 0; }
    /// Returns the point at x; `here` is the profile's place s.
    BelowAxle below_axle(double x, const ProfileCurve::Place& here, double s) const;
    /// Returns the radius of curvature along x (mm), infinite on a flat.
    double radius_along(double x, double s) const;

    /// Returns a point of the lower half in the wheel's coordinates, at a given x (mm) and s of the profile.
    Vector3 in_wheel(double x, double s) const;
    /// Returns a point of an out-of-round wheel's surface that corresponds between slices (OutOfRound::node), in the
    /// wheel's coordinates, at an angle from the lowest line of the wheel towards x.
    Vector3 slice_node(double angle, std::size_t index) const;
    /// Returns the first and the last such point that are visible from above at the lowest line.
    std::pair<std::size_t, std::size_t> seen_slice_nodes() const;
    /// Return the locus point of a round wheel at the profile's point s. The surface of the other body has the
    /// curvature `other` along x (1/mm), or a known slope at each x.
    LocusPoint locus(double s, double other = 0) const;
    LocusPoint locus(double s, const std::function<double(double x)>& other_slope) const;
    const Span& visible() const { return visible_; }
    /// Returns the wheel with the wheelset's centre lowered by dz.
    WheelSurface lowered(double dz) const;

    /// Returns the frame of the wheel in the track, which is the wheelset's frame if the wheelset is rigid.
    const Frame& frame() const { return frame_; }
    const Frame& wheelset() const { return wheelset_; }
    /// Returns the origin of the profile in the track.
    Vector3 profile_origin() const { return frame_.outside({0, base_y_, radius_}); }
    double base_y() const { return base_y_; }  ///< position of the profile's origin along the axle (mm)
    double nominal_radius() const { return radius_; }
    const ProfileCurve& profile() const { return profile_; }

   private:
    LocusPoint locus_point(const ProfileCurve::Place& here, double x, double x_slope) const;

    ProfileCurve profile_;
    double base_y_, radius_, pitch_;
    Frame wheelset_, frame_;
    std::shared_ptr<const OutOfRound> out_of_round_;
    Span visible_;
};

}  // namespace contactd::geometry
