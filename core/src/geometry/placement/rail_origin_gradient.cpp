#include "geometry/placement/rail_origin_gradient.hpp"

#include <cmath>

#include "geometry/placement/gauge_point.hpp"

namespace contactd::geometry {

// The origin is (gauge/2 - y of the gauge point, -z of the top). Both are extrema of the canted curve, whose values do
// not change with s, or lie at the gauge height, where s moves by (dz_top - dz)/z'.
void add_by_rail_origin(const Track& track, const ProfilePoint& by_origin, CurveCotangent& rail) {
    if (track.rail_origin || (by_origin.y == 0 && by_origin.z == 0)) return;
    const ProfileCurve& curve = rail.curve();
    const double cosine = std::cos(track.cant), sine = std::sin(track.cant);
    const auto add = [&](double s, double by_y, double by_z) {
        rail.add(s, {cosine * by_y - sine * by_z, sine * by_y + cosine * by_z});
    };
    const double at_top = s_of_top(curve, track.cant);
    double by_top = track.roller_radius ? 0 : -by_origin.z;
    const double depth = canted(curve.at(at_top), track.cant).z + track.gauge_height;
    const auto at_depth = s_of_depth(curve, track.cant, at_top, depth);
    const double from = at_depth.value_or(curve.begin());
    const double at_gauge = s_of_least_y(curve, track.cant, from, at_top);
    if (at_depth && at_gauge == from) {
        const ProfilePoint slope = canted(curve.slope(from), track.cant);
        const double lean = slope.y / slope.z;
        add(from, -by_origin.y, by_origin.y * lean);
        by_top -= by_origin.y * lean;
    } else {
        add(at_gauge, -by_origin.y, 0);
    }
    add(at_top, 0, by_top);
}

}  // namespace contactd::geometry
