#include <cstddef>

#include "geometry/adjoint/pair_cotangent.hpp"
#include "geometry/distance/heights.hpp"

namespace contactd::geometry {

void add_by_rail_normal(const RailSurface& rail, double s, double by_displacement, PairCotangent& sum,
                        double by_slope) {
    const ProfileCurve::Place here = rail.place(s);
    sum.rail_body.add({0, here.at.y, here.at.z}, by_displacement * Vector3{0, -here.slope.z, here.slope.y});
    sum.rail.add_normal(s, by_displacement, by_slope);
}

// The wheel's surface is F = x^2 + z^2 - rho^2 = 0 in its own coordinates, with its normal along grad F. A displacement
// of the profile along (-z', y') moves the surface along that normal by rho times as much.
Vector3 add_by_wheel_normal(const WheelSurface& wheel, const Vector3& at, double s, const Vector3& direction,
                            double by_distance, PairCotangent& sum) {
    const ProfileCurve::Place here = wheel.profile().place(s);
    const Vector3 inside = wheel.frame().inside(at);
    const double rho = wheel.nominal_radius() + here.at.z;
    const Vector3 normal =
        wheel.frame().axes * Vector3{inside.x * here.slope.y, -rho * here.slope.z, inside.z * here.slope.y};
    const double by_normal = by_distance / dot(normal, direction);
    const Vector3 by_position = by_normal * normal;
    sum.wheel_body.add(at, by_position);
    sum.wheel.add_normal(s, by_normal * rho);
    return by_position;
}

// A plane that moves has the same distances as if both surfaces moved the other way.
ContactReference add_by_distances(const WheelSurface& wheel, const RailSurface& rail, const ContactPlace& place,
                                  const std::vector<double>& by_distance, PairCotangent& sum) {
    const Frame plane = contact_frame(place.reference);
    const Grid& grid = place.grid;
    const std::vector<double> of_rail = rail_heights(rail, place.reference, grid),
                              of_wheel = wheel_heights(wheel, place.reference, grid);
    BodyCotangent both;
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy) {
        double of_row = 0;
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            if (by_distance[i] == 0) continue;
            of_row += by_distance[i];
            const Vector3 at = plane.outside({grid.x(ix), grid.y(iy), of_wheel[i]});
            const double s = wheel.profile().s_at_y(wheel.frame().inside(at).y - wheel.base_y());
            both.add(at, add_by_wheel_normal(wheel, at, s, plane.axes.z, -by_distance[i], sum));
        }
        if (of_row == 0) continue;
        const Vector3 at = plane.outside({0, grid.y(iy), of_rail[static_cast<std::size_t>(iy)]});
        const double s = rail.profile().s_at_y(rail.frame().inside(at).y);
        const ProfilePoint slope = rail.place(s).slope;
        const Vector3 normal{0, -slope.z, slope.y};
        const double by_normal = of_row / dot(normal, plane.axes.z);
        add_by_rail_normal(rail, s, by_normal, sum);
        both.add(at, by_normal * normal);
    }
    return {-both.force.x, -both.force.y, -both.force.z, -both.about_point(plane.origin).x};
}

}  // namespace contactd::geometry
