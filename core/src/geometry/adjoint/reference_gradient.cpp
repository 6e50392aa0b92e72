#include <algorithm>
#include <cmath>
#include <vector>

#include "contactd/error.hpp"
#include "geometry/adjoint/pair_cotangent.hpp"
#include "geometry/placement/ascending_root.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

/// Holds a row of the locus inside the overlap, with the derivatives of its values along y.
struct Row {
    double y = 0, depth = 0, angle = 0;
    double rail_s = 0, wheel_s = 0;
    ProfileCurve::Place rail;
    LocusPoint wheel;

    double rise() const { return rail.slope.z / rail.slope.y; }
    double depth_along() const { return wheel.slope.z / wheel.slope.y - rise(); }
    double x_along() const { return wheel.slope.x / wheel.slope.y; }
    double rise_along() const {
        const ProfilePoint &first = rail.slope, &second = rail.curving;
        return (second.z * first.y - first.z * second.y) / (first.y * first.y * first.y);
    }
};

/// Returns the rows of the locus search in the regions of a place.
std::vector<Row> rows_of(const WheelSurface& wheel, const RailSurface& rail, const ContactPlace& place, double step) {
    const Span &on_rail = rail.visible(), &on_wheel = wheel.visible();
    std::vector<Row> rows;
    for (const OverlapRegion& region : place.regions) {
        const double first = std::floor((region.y.from - on_rail.low) / step);
        const double last = std::ceil((region.y.to - on_rail.low) / step);
        Row row;
        row.rail_s = 0.5 * (on_rail.from + on_rail.to);
        row.wheel_s = wheel.profile().s_at_y(place.reference.y - wheel.frame().origin.y - wheel.base_y());
        for (double i = std::max(first, 0.0); i <= last; ++i) {
            row.y = on_rail.low + i * step;
            const auto wheel_at = [&](double s) {
                row.wheel = wheel.locus(s);
                return Sloped{row.wheel.at.y, row.wheel.slope.y};
            };
            if (!rail.find_y(row.y, row.rail_s) ||
                !find_ascending(wheel_at, row.y, on_wheel.from, on_wheel.to, row.wheel_s))
                continue;
            row.rail = rail.place(row.rail_s);
            row.wheel = wheel.locus(row.wheel_s);
            row.depth = row.wheel.at.z - row.rail.at.z;
            row.angle = std::atan(row.rise());
            if (row.depth > 0) rows.push_back(row);
        }
    }
    return rows;
}

/// Adds the gradient by x of the wheel's point at the row's y, whose place along the wheel follows its incline.
void add_by_x(const WheelSurface& wheel, const Row& row, double by_x, PairCotangent& sum) {
    if (by_x == 0) return;
    const auto& [X, Y, Z] = wheel.frame().axes;
    const ProfileCurve::Place here = wheel.profile().place(row.wheel_s);
    const Vector3 by_point{by_x, -by_x * row.x_along(), 0};  // at constant s
    sum.wheel_body.add(row.wheel.at, by_point);
    const Vector3 inside = wheel.frame().inside(row.wheel.at), by_inside = wheel.frame().axes.rotated_back(by_point);
    const double rho = wheel.nominal_radius() + here.at.z, incline = here.slope.z / here.slope.y, yaw = Y.x / X.x;
    const double by_along = by_inside.x - by_inside.z * inside.x / inside.z;
    const double by_incline = by_along * rho * yaw / here.slope.y;
    sum.wheel.add(row.wheel_s, {by_inside.y, by_inside.z * rho / inside.z + by_along * incline * yaw},
                  {-incline * by_incline, by_incline});
    const Vector3 rotated = rho * incline * (Y - yaw * X) - wheel.nominal_radius() * (Z - (Z.x / X.x) * X);
    sum.wheel_body.about = sum.wheel_body.about + (by_along / X.x) * Vector3{0, rotated.z, -rotated.y};
}

/// Adds the gradient by the height of the rail at the reference's y, and returns that by y.
double add_by_z(const RailSurface& rail, double y, double by_z, PairCotangent& sum) {
    double s = 0.5 * (rail.visible().from + rail.visible().to);
    rail.find_y(y, s);
    const ProfilePoint slope = rail.place(s).slope;
    add_by_rail_normal(rail, s, by_z / slope.y, sum);
    return by_z * slope.z / slope.y;
}

/// Adds the gradient by the position of all rows, which are counted from the first visible point of the rail.
void add_by_first_row(const RailSurface& rail, double by_y, PairCotangent& sum) {
    const double s = rail.visible().from;
    const ProfilePoint at = rail.place(s).at;
    const Rotation& axes = rail.frame().axes;
    sum.rail_body.add({0, at.y, at.z}, {0, by_y, 0});
    sum.rail.add(s, {axes.y.y * by_y, axes.z.y * by_y});
}

}  // namespace

// The weights are depth^2.5. Where regions form one patch, means of their references by size are those over all rows.
void add_by_reference(const WheelSurface& wheel, const RailSurface& rail, const ContactPlace& place, double step,
                      const ContactReference& by_reference, PairCotangent& sum) {
    const std::vector<Row> rows = rows_of(wheel, rail, place, step);
    double total = 0, angle = 0, x = 0, y = 0;
    for (const Row& row : rows) {
        const double weight = std::pow(row.depth, 2.5);
        total += weight;
        x += weight * row.wheel.at.x;
        y += weight * row.y;
        angle += weight * row.angle;
    }
    if (!(total > 0)) return;
    x /= total, y /= total, angle /= total;
    constexpr double same_angle = 1e-6;  // rad
    if (!(std::abs(angle - place.reference.angle) < same_angle))
        throw InvalidArgument("patches.distance_turn",
                              "rotates the plane of the contact at y = " + short_text(place.reference.y) +
                                  " mm towards its neighbour, which gradients do not cover; decrease it");
    const double by_y = by_reference.y + add_by_z(rail, place.reference.y, by_reference.z, sum);
    double by_first_row = 0;
    for (const Row& row : rows) {
        const double weight = std::pow(row.depth, 2.5) / total;
        const double by_depth =
            2.5 * weight / row.depth *
            (by_reference.x * (row.wheel.at.x - x) + by_y * (row.y - y) + by_reference.angle * (row.angle - angle));
        const double cosine = std::cos(row.angle), by_rise = weight * by_reference.angle * cosine * cosine;
        const double by_x = weight * by_reference.x, across = row.rail.slope.y;
        const double aside = -by_rise * row.rise_along();
        by_first_row += weight * by_y + by_depth * row.depth_along() - aside + by_x * row.x_along();
        add_by_wheel_normal(wheel, row.wheel.at, row.wheel_s, {0, 0, 1}, by_depth, sum);
        add_by_rail_normal(rail, row.rail_s, -by_depth / across, sum);
        sum.rail.add_normal(row.rail_s, -by_rise * row.rail.curving.y / (across * across * across),
                            by_rise / (across * across));
        sum.rail_body.add({0, row.rail.at.y, row.rail.at.z}, {0, aside, 0});
        sum.rail_body.about.x += weight * by_reference.angle;
        add_by_x(wheel, row, by_x, sum);
    }
    add_by_first_row(rail, by_first_row, sum);
}

}  // namespace contactd::geometry
