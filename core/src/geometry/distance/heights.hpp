// Heights of wheel and rail over a contact plane, along its normal, at the elements of a grid.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "contactd/grid.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Where a surface does not stand above the plane.
inline constexpr double no_height = std::numeric_limits<double>::quiet_NaN();

/// Axes of the contact in the track.
inline Frame contact_frame(const ContactReference& reference) {
    return {{reference.x, reference.y, reference.z}, Rotation::roll(reference.angle)};
}

/// Where heights are wanted: columns along x as those of a grid, and rows across, which ascend and may be anywhere.
struct PlanePoints {
    /// The elements of a grid that lies in the plane.
    PlanePoints(const Grid& grid) : columns(grid) {  // NOLINT(google-explicit-constructor): a grid is such points
        for (int iy = 0; iy < grid.ny; ++iy) rows.push_back(grid.y(iy));
    }
    /// Rows of their own (mm); dy of the grid is about how far they are apart.
    PlanePoints(const Grid& grid, std::vector<double> rows_) : columns(grid), rows(std::move(rows_)) {}

    double x(int ix) const { return columns.x(ix); }
    int nx() const { return columns.nx; }

    Grid columns;
    std::vector<double> rows;
};

/// Heights of the rail's surface, shape [ny, nx] (mm), or [ny] of a rail that is the same all along.
std::vector<double> rail_heights(const RailSurface& rail, const ContactReference& reference, const PlanePoints& points);

/// How a rail that varies along the track rises over a contact plane by x: at the reference, and at the elements where
/// these have heights, shape [ny, nx]; not a number where the rail has none on either side. All is zero, and there are
/// no elements, of a rail that is the same all along.
struct SlopesAlong {
    double at_reference = 0;
    std::vector<double> at_elements{};

    bool is_level() const { return at_reference == 0 && at_elements.empty(); }
    double at(std::size_t element) const {
        return at_elements.empty() || !std::isfinite(at_elements[element]) ? at_reference : at_elements[element];
    }
};
/// At the reference.
SlopesAlong rail_slopes(const RailSurface& rail, const ContactReference& reference);
/// Adds those at the elements of a grid, by their heights.
void add_slopes_at_elements(SlopesAlong& slopes, const Grid& grid, const std::vector<double>& heights);

/// Heights of the wheel's surface, shape [ny, nx] (mm): those of rows in which a polynomial through a few of them has
/// settled are its values.
std::vector<double> wheel_heights(const WheelSurface& wheel, const ContactReference& reference,
                                  const PlanePoints& points, double settled = 1e-10);

/// An element has its middle here, in the coordinates of a contact (mm).
struct ElementMiddle {
    double x = 0, y = 0;
};

/// A place with what decides where the nodes of a mesh lie: the grid that it needs, before any element beside that, and
/// where elements are counted from, in the plane.
struct MeshedPlace {
    const ContactPlace& place;
    Grid needed;
    ElementMiddle counted_from;
};

/// Heights of a wheel by the nodes of a mesh on it: as wide as the elements, along x and along its profile, and
/// straight between them. That of an out-of-round wheel is as wide as the elements along x, has the points of slices
/// that correspond across (OutOfRound), and cubics between.
std::vector<double> meshed_wheel_heights(const WheelSurface& wheel, const MeshedPlace& found,
                                         const PlanePoints& points);

}  // namespace contactd::geometry
