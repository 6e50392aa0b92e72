// Describes a contact that is curved across the track by rows of elements half-way between rail and wheel.
#pragma once

#include <vector>

#include "contactd/grid.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "geometry/placement/rail_surface.hpp"
#include "geometry/placement/wheel_surface.hpp"

namespace contactd::geometry {

/// Holds rows at multiples of a step along the surfaces, counted from a row at or beside the reference.
struct CurvedRows {
    int first = 0;
    std::vector<ContactRow> rows;
    /// These are the arc lengths of the first row along both profiles, from their beginning (mm).
    double on_rail = 0, on_wheel = 0;

    /// Returns the positions of the rows in the plane of the reference, across the track.
    std::vector<double> in_plane(const ContactReference& reference) const;
};

/// Returns the rows whose middle lies between `y`, where both surfaces face each other, with two more on both sides,
/// plus `more_below` and `more_above`. Points of rail and wheel are at equal arc lengths from the reference, and the
/// row from which rows are counted is at `middle`.
CurvedRows curved_rows(const WheelSurface& wheel, const RailSurface& rail, const ContactReference& reference,
                       const Extent& y, double step, double middle = 0, int more_below = 0, int more_above = 0);

}  // namespace contactd::geometry
