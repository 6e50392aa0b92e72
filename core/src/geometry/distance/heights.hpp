// Computes heights of wheel and rail over a contact plane, along its normal, at the elements of a grid.
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

/// A surface has this height where it does not stand above the plane.
inline constexpr double no_height = std::numeric_limits<double>::quiet_NaN();

/// Returns the axes of the contact in the track.
inline Frame contact_frame(const ContactReference& reference) {
    return {{reference.x, reference.y, reference.z}, Rotation::roll(reference.angle)};
}

/// Describes the points for heights: columns along x like those of a grid, and rows across in any ascending positions.
struct PlanePoints {
    /// Uses the elements of a grid in the plane.
    PlanePoints(const Grid& grid) : columns(grid) {  // NOLINT(google-explicit-constructor): a grid is such points
        for (int iy = 0; iy < grid.ny; ++iy) rows.push_back(grid.y(iy));
    }
    /// Uses separate rows (mm); dy of the grid is about their distance.
    PlanePoints(const Grid& grid, std::vector<double> rows_) : columns(grid), rows(std::move(rows_)) {}

    double x(int ix) const { return columns.x(ix); }
    int nx() const { return columns.nx; }

    Grid columns;
    std::vector<double> rows;
};

/// Returns heights of the rail's surface, shape [ny, nx] (mm), or [ny] for a rail that is uniform along x.
std::vector<double> rail_heights(const RailSurface& rail, const ContactReference& reference, const PlanePoints& points);

/// Describes how a rail that varies along the track rises over a contact plane along x: at the reference, and at
/// elements with heights, shape [ny, nx]. Entries are NaN if the rail has no height on either side. For a rail that is
/// uniform along x, the slope is zero and there are no elements.
struct SlopesAlong {
    double at_reference = 0;
    std::vector<double> at_elements{};

    bool is_level() const { return at_reference == 0 && at_elements.empty(); }
    double at(std::size_t element) const {
        return at_elements.empty() || !std::isfinite(at_elements[element]) ? at_reference : at_elements[element];
    }
};
/// Returns the slope at the reference.
SlopesAlong rail_slopes(const RailSurface& rail, const ContactReference& reference);
/// Adds slopes at the elements of a grid, from their heights.
void add_slopes_at_elements(SlopesAlong& slopes, const Grid& grid, const std::vector<double>& heights);

/// Returns heights of the wheel's surface, shape [ny, nx] (mm). In rows in which a polynomial through a few of them has
/// settled, they are values of the polynomial.
std::vector<double> wheel_heights(const WheelSurface& wheel, const ContactReference& reference,
                                  const PlanePoints& points, double settled = 1e-10);

/// Describes the middle of an element, in the coordinates of a contact (mm).
struct ElementMiddle {
    double x = 0, y = 0;
};

/// Describes a place with the quantities that determine the nodes of a mesh: the grid that it needs, before other
/// elements are added, and the origin of counting elements in the plane.
struct MeshedPlace {
    const ContactPlace& place;
    Grid needed;
    ElementMiddle counted_from;
};

/// Returns heights of a wheel from the nodes of a mesh on it. The mesh is as wide as the elements, along x and along
/// its profile, and linear between nodes. That of an out-of-round wheel is as wide as the elements along x, has the
/// corresponding points of slices across (OutOfRound), and is cubic between nodes.
std::vector<double> meshed_wheel_heights(const WheelSurface& wheel, const MeshedPlace& found,
                                         const PlanePoints& points);

}  // namespace contactd::geometry
