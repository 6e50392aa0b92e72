#include <cmath>
#include <numbers>

#include "geometry/section/ready_made.hpp"

namespace contactd::geometry {
namespace {

using std::numbers::pi;

OutlinePart line(double y, double z) {
    return {LineTo{{y, z}}};
}
OutlinePart clamped_line(double y, double z) {
    return {LineTo{{y, z}}, true};
}
OutlinePart arc(double y, double z, double radius) {
    return {ArcTo{{y, z}, radius}};
}

// Returns a circle from -radius over the top and back below; as a hole, it runs below first and back over the top.
Outline circle(double radius, bool clamped) {
    return {{-radius, 0}, {{ArcTo{{radius, 0}, radius}, clamped}, {ArcTo{{-radius, 0}, radius}, clamped}}};
}
Outline round_hole(double radius, bool clamped) {
    return {{-radius, 0}, {{ArcTo{{radius, 0}, -radius}, clamped}, {ArcTo{{-radius, 0}, -radius}, clamped}}};
}

}  // namespace

OutlineSection outline_of(const EdgeBlock& block, double width) {
    const double b = block.width, h = block.height;
    return {.outside = {{-b, 0}, {line(0, 0), line(0, -h), clamped_line(-b, -h), clamped_line(-b, 0)}},
            .from = b - block.edge_distance - width};
}

OutlineSection outline_of(const Groove& groove, double width) {
    const double r = groove.radius, d = groove.depth, b = groove.width / 2, h = groove.height;
    const double opening = std::sqrt(d * (2 * r - d));
    return {.outside = {{-b, -h},
                        {line(-b, 0), line(-opening, 0), arc(opening, 0, -r), line(b, 0), line(b, -h),
                         clamped_line(-b, -h)}},
            .part = 2,
            .from = r * std::atan2(opening, r - d) - width / 2};
}

OutlineSection outline_of(const RoundEnd& end, double width) {
    const double r = end.radius, h = end.length;
    return {.outside = {{-r, -h}, {line(-r, 0), arc(r, 0, r), line(r, -h), clamped_line(-r, -h)}},
            .part = 1,
            .from = r * pi / 2 - width / 2};
}

OutlineSection outline_of(const Disc& disc, double width) {
    OutlineSection section{.outside = circle(disc.radius, false), .from = disc.radius * pi / 2 - width / 2};
    if (disc.core > 0) section.holes = {round_hole(disc.core, true)};
    return section;
}

OutlineSection outline_of(const PlateHole& hole, double width) {
    return {.outside = circle(hole.plate_radius, true),
            .holes = {round_hole(hole.radius, false)},
            .carrier = 1,
            .from = hole.radius * pi / 2 - width / 2};
}

OutlineSection outline_of(const Slab& slab, double width) {
    const double b = slab.width / 2, t = slab.thickness;
    return {.outside = {{-b, -t}, {clamped_line(-b, 0), line(b, 0), clamped_line(b, -t), clamped_line(-b, -t)}},
            .part = 1,
            .from = b - width / 2};
}

}  // namespace contactd::geometry
