// A right rail, or the roller in its place, in track coordinates.
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

/// The profile's origin in the track where the rail does not deviate; the profile leans inwards by track.cant. Throws
/// InvalidArgument ("track.gauge_height") where only the other side reaches down to it.
ProfilePoint rail_origin(const ProfileCurve& profile, const Track& track);

/// The profile at x = 0, and how the surface goes on from there along the track: straight, around a roller's axle, or
/// from slice to slice.
class RailSurface {
   public:
    /// `origin` is that of rail_origin.
    RailSurface(ProfileCurve profile, const Track& track, ProfilePoint origin, const RailDeviation& deviation);
    /// Makes the surface of slices, from `x` along the track on.
    RailSurface(std::shared_ptr<const SlicedRail> slices, double x, const Track& track, ProfilePoint origin,
                const RailDeviation& deviation);

    /// The profile at x = 0, placed: the point and its derivatives by s.
    ProfileCurve::Place place(double s) const { return placed(profile_, s); }
    /// Places a profile of the same rail elsewhere.
    ProfileCurve::Place placed(const ProfileCurve& profile, double s) const;
    /// Returns the part of the profile that is seen from above.
    const Span& visible() const { return visible_; }
    /// Finds the s of the visible part that has this y; `s` is where to start.
    bool find_y(double y, double& s) const;

    /// Height of the surface at (x, y); y is that of the visible part, `s` is where to start.
    double height(double x, double y, double s) const;
    /// Returns the height where the profile has z at x = 0; not a number where there is none.
    double z_at(double x, double y, double z) const;
    double slope_along(double x, double y, double z) const;  ///< its derivative by x
    bool varies() const { return axle_ || slices_; }         ///< along the track
    bool is_sliced() const { return slices_ != nullptr; }
    /// The profile at x; that of rollers is turned about their axle, by `turned_to`.
    ProfileCurve section(double x) const { return slices_ ? slices_->at(x_ + x) : profile_; }
    /// Returns where the next slice behind x is; infinite where there is none.
    double next_slice(double x) const {
        return slices_ ? slices_->next_slice(x_ + x) - x_ : std::numeric_limits<double>::infinity();
    }
    /// The slices, and where x = 0 is along them; null where there are none.
    const SlicedRail* slices() const { return slices_.get(); }
    double along_slices() const { return x_; }
    /// Places a point of a profile of the same rail.
    ProfilePoint placed(const ProfilePoint& point) const;
    /// Between columns of slices this far apart, at multiples of it, the surface is cubic along the track (mm).
    static constexpr double step_along = 2;
    /// Returns where a place of the profile comes at x, with its first derivative: on a roller it turns.
    ProfileCurve::Place turned_to(double x, ProfileCurve::Place place) const;

    /// 1/R of a roller along x (1/mm); zero of a rail, sliced or not.
    double curvature_along() const { return axle_ ? 1 / *radius_ : 0; }
    /// Returns the curvature along the track at a point, also of slices; positive where convex. `s` is as for height.
    double curvature_along(double x, double y, double s) const;
    /// Returns 1/r of a roller, r its radius at a place of the profile (1/mm); zero of a rail, sliced or not.
    double curvature_around(const ProfilePoint& at) const { return axle_ ? 1 / radius_at(at) : 0; }
    /// z of the axle that a roller turns about, which lies along y.
    std::optional<double> axle() const { return axle_; }

    const Frame& frame() const { return frame_; }
    const ProfileCurve& profile() const { return profile_; }

   private:
    /// A profile that was needed, as far as it is seen from above, and where it was looked at last.
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
    double x_ = 0;  // of the origin, along the slices
    ProfileCurve profile_;
    Frame frame_;
    double cosine_, sine_;
    Span visible_;
    std::optional<double> radius_, axle_;
    ProfilePoint inwards_{0, 1};    // of a roller: the direction from its surface to the axle that this lies about,
    double from_inwards_axle_ = 0;  // and how far the track's origin is from that axle, along it
    mutable std::map<int, Column> columns_;  // of slices: one surface is one thread's
};

}  // namespace contactd::geometry
