// Represents a right rail, or the roller in its place, in track coordinates.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>

#include "contactd/profile.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/sliced_rail.hpp"
#include "geometry/placement/span.hpp"
#include "geometry/placement/vector3.hpp"

namespace contactd::geometry {

/// Returns the profile's origin in the track without deviations of the rail; the profile leans inwards by track.cant.
/// Throws InvalidArgument ("track.gauge_height") if only the other side extends down to it.
ProfilePoint rail_origin(const ProfileCurve& profile, const Track& track);

/// Holds the profile at x = 0, and the continuation of the surface along the track: straight, around a roller's axle,
/// or from slice to slice.
class RailSurface {
   public:
    /// `origin` is that of rail_origin.
    RailSurface(ProfileCurve profile, const Track& track, ProfilePoint origin, const RailDeviation& deviation);
    /// Makes the surface of slices, from `x` along the track on.
    RailSurface(std::shared_ptr<const SlicedRail> slices, double x, const Track& track, ProfilePoint origin,
                const RailDeviation& deviation);

    /// Returns a point of the profile at x = 0 in the track, and its derivatives by s.
    ProfileCurve::Place place(double s) const { return placed(profile_, s); }
    /// Places a point of another profile of the same rail.
    ProfileCurve::Place placed(const ProfileCurve& profile, double s) const;
    /// Returns the part of the profile that is visible from above.
    const Span& visible() const { return visible_; }
    /// Finds the s of the visible part at this y; `s` is the start.
    bool find_y(double y, double& s) const;

    /// Returns the height of the surface at (x, y); y is in the visible part, and `s` is the start.
    double height(double x, double y, double s) const;
    /// Returns the height at x where the profile has z at x = 0, or NaN if there is none.
    double z_at(double x, double y, double z) const;
    double slope_along(double x, double y, double z) const;  ///< its derivative by x
    bool varies() const { return axle_ || slices_; }         ///< whether the surface varies along the track
    bool is_sliced() const { return slices_ != nullptr; }
    /// Returns the profile at x; that of rollers is rotated about their axle by `rotated_to`.
    ProfileCurve section(double x) const { return slices_ ? slices_->at(x_ + x) : profile_; }
    /// Returns the position of the next slice behind x; infinite if there is none.
    double next_slice(double x) const {
        return slices_ ? slices_->next_slice(x_ + x) - x_ : std::numeric_limits<double>::infinity();
    }
    /// Return the slices, or null without slices, and the position of x = 0 along them.
    const SlicedRail* slices() const { return slices_.get(); }
    double along_slices() const { return x_; }
    /// Places a point of a profile of the same rail.
    ProfilePoint placed(const ProfilePoint& point) const;
    /// Between columns of slices at multiples of this distance (mm), the surface is cubic along the track.
    static constexpr double step_along = 2;
    /// Returns the position of a place of the profile at x, with its first derivative; on a roller it rotates.
    ProfileCurve::Place rotated_to(double x, ProfileCurve::Place place) const;

    /// Returns 1/R of a roller along x (1/mm), which is zero for a rail with or without slices.
    double curvature_along() const { return axle_ ? 1 / *radius_ : 0; }
    /// Returns the curvature along the track at a point, also for slices; positive where convex. `s` is as for height.
    double curvature_along(double x, double y, double s) const;
    /// Returns 1/r of a roller, with r its radius at a place of the profile (1/mm), which is zero for a rail with or
    /// without slices.
    double curvature_around(const ProfilePoint& at) const { return axle_ ? 1 / radius_at(at) : 0; }
    /// Returns z of the axle about which a roller rotates, along y.
    std::optional<double> axle() const { return axle_; }

    const Frame& frame() const { return frame_; }
    const ProfileCurve& profile() const { return profile_; }

   private:
    /// Holds a profile that was used, as far as it is visible from above, and the position of the last search.
    struct Column {
        ProfileCurve profile;
        Span visible;
        double s;
    };

    double radius_at(const ProfilePoint& at) const {
        return from_inwards_axle_ - inwards_.y * at.y - inwards_.z * at.z;
    }
    double sag(double x, const ProfilePoint& at) const;
    bool leans() const { return inwards_.y != 0; }
    Span visible_part(const ProfileCurve& profile) const;
    double column_z(int column, double y) const;

    std::shared_ptr<const SlicedRail> slices_;
    double x_ = 0;  // position of the origin, along the slices
    ProfileCurve profile_;
    Frame frame_;
    double cosine_, sine_;
    Span visible_;
    std::optional<double> radius_, axle_;
    ProfilePoint inwards_{0, 1};             // for a roller: the direction from its surface to the axle of its surface
    double from_inwards_axle_ = 0;           // distance of the track's origin from that axle, along that direction
    mutable std::map<int, Column> columns_;  // columns of slices; each surface belongs to one thread
};

}  // namespace contactd::geometry
