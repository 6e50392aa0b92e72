// Holds the gradient of a number by the surfaces of a wheel and its rail.
#pragma once

#include "contactd/wheel_rail_solution.hpp"
#include "geometry/adjoint/body_cotangent.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"
#include "geometry/profile/curve_cotangent.hpp"

namespace contactd::geometry {

/// Sums over all patches, by the profiles and by the motion of both bodies.
struct PairCotangent {
    PairCotangent(const WheelSurface& wheel_, const RailSurface& rail_)
        : wheel(wheel_.profile()), rail(rail_.profile()) {}

    CurveCotangent wheel, rail;
    BodyCotangent wheel_body, rail_body;
};

/// Adds the gradient by the displacement of the rail's surface along its normal (0, -z', y') at s of its profile, and
/// by the derivative of the profile's part with respect to s.
void add_by_rail_normal(const RailSurface& rail, double s, double by_displacement, PairCotangent& sum,
                        double by_slope = 0);

/// Adds the gradient by the displacement of the wheel's surface at a point, over its component along `direction`, and
/// returns that by the position of the point. Distances along that direction have this form.
Vector3 add_by_wheel_normal(const WheelSurface& wheel, const Vector3& at, double s, const Vector3& direction,
                            double by_distance, PairCotangent& sum);

/// Adds the gradient by the distances of rail and wheel over the plane of a place, shape [ny, nx], in fixed places of
/// the plane. Returns the gradient by the plane's position, which moves the elements.
ContactReference add_by_distances(const WheelSurface& wheel, const RailSurface& rail, const ContactPlace& place,
                                  const std::vector<double>& by_distance, PairCotangent& sum);

/// Adds the gradient by the reference of a place, which is a mean over the rows of the locus with this step (mm).
/// Throws InvalidArgument ("patches.distance_turn") if the plane was rotated towards its neighbour.
void add_by_reference(const WheelSurface& wheel, const RailSurface& rail, const ContactPlace& place, double step,
                      const ContactReference& by_reference, PairCotangent& sum);

}  // namespace contactd::geometry
