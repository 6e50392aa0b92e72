// A right wheel in track coordinates: a surface of revolution about the wheelset's axle, rolled and yawed.
#pragma once

#include <functional>

#include "contactd/profile.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "geometry/placement/span.hpp"
#include "geometry/placement/vector3.hpp"

namespace contactd::geometry {

/// A point of the wheel where its distance to the rail is least along the track.
struct LocusPoint {
    Vector3 at;          ///< in track coordinates
    double y_slope = 0;  ///< of at.y, by s
};

class WheelSurface {
   public:
    WheelSurface(ProfileCurve profile, const Wheelset& wheelset, const WheelsetPosition& position);

    /// Of the lower half, x along the wheelset's axis (mm) and s of the profile: in the wheelset's coordinates.
    Vector3 in_wheelset(double x, double s) const;
    /// Of the profile's point s where the surface of the other body has the curvature `other` along x (1/mm), or a
    /// slope that is known at each x.
    LocusPoint locus(double s, double other = 0) const;
    LocusPoint locus(double s, const std::function<double(double x)>& other_slope) const;
    const Span& visible() const { return visible_; }
    /// The same wheel, with the wheelset's centre lower by dz.
    WheelSurface lowered(double dz) const;

    /// Wheelset in the track.
    const Frame& frame() const { return frame_; }
    double base_y() const { return base_y_; }  ///< of the profile's origin along the axle (mm)
    double nominal_radius() const { return radius_; }
    const ProfileCurve& profile() const { return profile_; }

   private:
    LocusPoint locus_point(const ProfileCurve::Place& here, double x, double x_slope) const;

    ProfileCurve profile_;
    Frame frame_;
    double base_y_, radius_;
    Span visible_;
};

}  // namespace contactd::geometry
