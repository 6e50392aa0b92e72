#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/distance/heights.hpp"
#include "geometry/distance/node_mesh.hpp"

namespace contactd::geometry {
namespace {

/// Returns the nearest multiple of a step, counted from `from`.
double nearest(double from, double to, double step) {
    return from + step * std::round((to - from) / step);
}

/// Returns nodes at distances of the elements, along x and along the profile, in the coordinates of the contact.
NodeMesh round_mesh(const WheelSurface& wheel, const ContactReference& reference, const PlanePoints& points,
                    const ElementMiddle& counted_from) {
    constexpr int spare = 8;
    const Grid& grid = points.columns;
    // Rows that bend away from the plane are dy apart along the surface, and less in the plane.
    const double farthest = std::max({std::abs(points.rows.front()), std::abs(points.rows.back()), std::abs(grid.y(0)),
                                      std::abs(grid.y(grid.ny - 1))});
    const Frame contact = contact_frame(reference);
    const ProfileCurve& profile = wheel.profile();
    const auto on_profile = [&](const Vector3& at) {
        return profile.arc_length(profile.s_at_y(at.y - wheel.base_y()));
    };
    const Vector3 origin = wheel.frame().inside(contact.origin);
    const Vector3 counted = wheel.frame().inside(contact.outside({counted_from.x, counted_from.y, 0}));
    const double x = nearest(counted.x, origin.x, grid.dx);
    const double s = nearest(on_profile(counted), on_profile(origin), grid.dy);
    const int columns = spare + static_cast<int>(std::max(std::abs(grid.x0), grid.x0 + grid.nx * grid.dx) / grid.dx);
    const int rows = spare + static_cast<int>(1.2 * (farthest + 0.5 * grid.dy) / grid.dy);
    std::vector<Vector3> nodes;
    for (int j = -rows; j <= rows; ++j) {
        const double at = profile.s_at_arc_length(s + j * grid.dy);
        for (int i = -columns; i <= columns; ++i)
            nodes.push_back(contact.inside(wheel.frame().outside(wheel.in_wheel(x + i * grid.dx, at))));
    }
    return {static_cast<std::size_t>(2 * columns + 1), std::move(nodes), NodeMesh::Between::straight};
}

/// Returns nodes of an out-of-round wheel at corresponding points of the slices. Their angles are about an element
/// apart, from two elements before the needed ones to two behind them.
NodeMesh sliced_mesh(const WheelSurface& wheel, const MeshedPlace& found) {
    constexpr int spare = 12;  // additional nodes on both sides, for elements that are not needed
    const ContactReference& reference = found.place.reference;
    const Grid& needed = found.needed;
    const Frame contact = contact_frame(reference);
    Extent y = found.place.regions.front().y;
    for (const OverlapRegion& region : found.place.regions)
        y = {std::min(y.from, region.y.from), std::max(y.to, region.y.to)};
    const double sine = std::sin(reference.angle), radius = wheel.nominal_radius();
    const double first_row = needed.y0, last_row = needed.y0 + needed.ny * needed.dy;
    Extent x{1e300, -1e300};
    double least_z = 1e300;
    for (const double ahead : {needed.x0, needed.x0 + needed.nx * needed.dx})
        for (const bool is_first : {true, false}) {
            const double z = reference.z + (is_first ? first_row : last_row) * sine;
            const Vector3 corner = wheel.frame().inside({reference.x + ahead, is_first ? y.from : y.to, z});
            x = {std::min(x.from, corner.x), std::max(x.to, corner.x)};
            least_z = std::min(least_z, corner.z);
        }
    least_z -= needed.dy * std::abs(sine);
    const double from = std::atan((x.from - 2 * needed.dx) / least_z), to = std::atan((x.to + 2 * needed.dx) / least_z);
    const auto [first, last] = wheel.seen_slice_nodes();
    const double lines = std::round((to - from) * radius / needed.dx) + 2;
    long columns = static_cast<long>(lines_within_bound(lines + 2 * spare, last - first + 1)) - 2 * spare;
    columns += columns % 2 == 0 ? 1 : 0;
    const double step = (to - from) / static_cast<double>(columns - 1);
    std::vector<Vector3> nodes;
    for (std::size_t j = first; j <= last; ++j)
        for (long i = -spare; i < columns + spare; ++i)
            nodes.push_back(
                contact.inside(wheel.frame().outside(wheel.slice_node(from + static_cast<double>(i) * step, j))));
    return {static_cast<std::size_t>(columns + 2 * spare), std::move(nodes), NodeMesh::Between::cubic};
}

}  // namespace

std::vector<double> meshed_wheel_heights(const WheelSurface& wheel, const MeshedPlace& found,
                                         const PlanePoints& points) {
    NodeMesh mesh = wheel.is_round() ? round_mesh(wheel, found.place.reference, points, found.counted_from)
                                     : sliced_mesh(wheel, found);
    std::vector<double> heights;
    for (const double y : points.rows)
        for (int ix = 0; ix < points.nx(); ++ix) heights.push_back(mesh.height(points.x(ix), y));
    return heights;
}

}  // namespace contactd::geometry
