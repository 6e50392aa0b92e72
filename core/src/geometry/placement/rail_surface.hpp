// A right rail, or the roller in its place, in track coordinates.
#pragma once

#include <optional>

#include "contactd/profile.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/span.hpp"
#include "geometry/placement/vector3.hpp"

namespace contactd::geometry {

/// The profile's origin in the track where the rail does not deviate; the profile leans inwards by track.cant. Throws
/// InvalidArgument ("track.gauge_height") where the profile has no gauge point.
ProfilePoint rail_origin(const ProfileCurve& profile, const Track& track);

class RailSurface {
   public:
    /// `origin` is that of rail_origin.
    RailSurface(ProfileCurve profile, const Track& track, ProfilePoint origin, const RailDeviation& deviation);

    /// The profile at x = 0, placed: the point and its derivatives by s.
    ProfileCurve::Place place(double s) const;
    /// Of the profile, as far as it is seen from above.
    const Span& visible() const { return visible_; }
    /// Finds the s of the visible part that has this y; `s` is where to start.
    bool find_y(double y, double& s) const;

    /// Height of the surface at x above the point of the profile that has z at x = 0.
    double z_at(double x, double z) const { return axle_ ? roller_z(x, z) : z; }
    double z_slope_at(double x, double z) const;  ///< its derivative by z
    /// 1/R of the surface along x (1/mm), positive where convex; zero of a rail.
    double curvature_along() const { return axle_ ? 1 / *radius_ : 0; }
    std::optional<double> axle() const { return axle_; }  ///< z of a roller's axle, which lies along y

    const Frame& frame() const { return frame_; }
    const ProfileCurve& profile() const { return profile_; }

   private:
    double roller_z(double x, double z) const;

    ProfileCurve profile_;
    Frame frame_;
    double cosine_, sine_;
    Span visible_;
    std::optional<double> radius_, axle_;
};

}  // namespace contactd::geometry
