#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/distance/heights.hpp"

namespace contactd::geometry {
namespace {

/// Nodes (i, j), -i_most..i_most and -j_most..j_most, in the coordinates of the contact.
class Mesh {
   public:
    Mesh(const WheelSurface& wheel, const ContactReference& reference, const PlanePoints& points,
         const ElementMiddle& counted_from) {
        const Grid& grid = points.columns;
        // Rows that bend away from the plane are dy apart along the surface, and less in the plane.
        const double farthest = std::max({std::abs(points.rows.front()), std::abs(points.rows.back()),
                                          std::abs(grid.y(0)), std::abs(grid.y(grid.ny - 1))});
        const Frame contact = contact_frame(reference);
        const ProfileCurve& profile = wheel.profile();
        const auto on_profile = [&](const Vector3& at) {
            return profile.arc_length(profile.s_at_y(at.y - wheel.base_y()));
        };
        const Vector3 origin = wheel.frame().inside(contact.origin);
        const Vector3 counted = wheel.frame().inside(contact.outside({counted_from.x, counted_from.y, 0}));
        // The nodes next to the reference.
        const auto nearest = [](double from, double to, double step) {
            return from + step * std::round((to - from) / step);
        };
        const double middle = nearest(counted.x, origin.x, grid.dx);
        const double s = nearest(on_profile(counted), on_profile(origin), grid.dy);
        constexpr int spare = 8;
        i_most_ = spare + static_cast<int>(std::max(std::abs(grid.x0), grid.x0 + grid.nx * grid.dx) / grid.dx);
        j_most_ = spare + static_cast<int>(1.2 * (farthest + 0.5 * grid.dy) / grid.dy);
        dx_ = grid.dx;
        dy_ = grid.dy;
        for (int j = -j_most_; j <= j_most_; ++j) {
            const double at = profile.s_at_arc_length(s + j * grid.dy);
            for (int i = -i_most_; i <= i_most_; ++i)
                nodes_.push_back(contact.inside(wheel.frame().outside(wheel.in_wheel(middle + i * grid.dx, at))));
        }
    }

    /// From cell to cell until the point lies in it.
    double height(double x, double y) const {
        int i = static_cast<int>(std::floor(x / dx_)), j = static_cast<int>(std::floor(y / dy_));
        for (int moves = 0; moves < 4 * (i_most_ + j_most_); ++moves) {
            if (i < -i_most_ || i >= i_most_ || j < -j_most_ || j >= j_most_) return no_height;
            const auto [u, v] = inside_cell(i, j, x, y);
            const int across = u < -slack ? -1 : u > 1 + slack ? 1 : 0, up = v < -slack ? -1 : v > 1 + slack ? 1 : 0;
            if (across == 0 && up == 0) return interpolated(i, j, u, v).z;
            i += across;
            j += up;
        }
        return no_height;
    }

   private:
    static constexpr double slack = 1e-9;
    struct Shares {
        double u, v;
    };

    const Vector3& node(int i, int j) const {
        const int at = (j + j_most_) * (2 * i_most_ + 1) + i + i_most_;
        return nodes_[static_cast<std::size_t>(at)];
    }
    Vector3 interpolated(int i, int j, double u, double v) const {
        return (1 - v) * ((1 - u) * node(i, j) + u * node(i + 1, j)) +
               v * ((1 - u) * node(i, j + 1) + u * node(i + 1, j + 1));
    }
    Shares inside_cell(int i, int j, double x, double y) const {
        double u = 0.5, v = 0.5;
        for (int iteration = 0; iteration < 6; ++iteration) {
            const Vector3 at = interpolated(i, j, u, v);
            const Vector3 by_u = interpolated(i, j, 1, v) - interpolated(i, j, 0, v);
            const Vector3 by_v = interpolated(i, j, u, 1) - interpolated(i, j, u, 0);
            const double area = by_u.x * by_v.y - by_u.y * by_v.x, off_x = x - at.x, off_y = y - at.y;
            u += (off_x * by_v.y - off_y * by_v.x) / area;
            v += (by_u.x * off_y - by_u.y * off_x) / area;
        }
        return {u, v};
    }

    int i_most_ = 0, j_most_ = 0;
    double dx_ = 0, dy_ = 0;
    std::vector<Vector3> nodes_;
};

}  // namespace

std::vector<double> meshed_wheel_heights(const WheelSurface& wheel, const ContactReference& reference,
                                         const PlanePoints& points, const ElementMiddle& counted_from) {
    const Mesh mesh(wheel, reference, points, counted_from);
    std::vector<double> heights;
    for (const double y : points.rows)
        for (int ix = 0; ix < points.nx(); ++ix) heights.push_back(mesh.height(points.x(ix), y));
    return heights;
}

}  // namespace contactd::geometry
