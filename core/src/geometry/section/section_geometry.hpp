// A section as curves: its outline and holes by arc length, and the columns on one of them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "contactd/section.hpp"
#include "geometry/section/closed_curve.hpp"

namespace contactd::geometry {

/// By more than this (rad) a curve turns at a corner; less are roundings of coordinates.
inline constexpr double least_corner = 0.02;
/// What a column's arc may turn by (rad).
inline constexpr double most_column_turn = 0.5;

class SectionGeometry {
   public:
    /// `ds` is the arc length of a column (mm). Throws InvalidArgument below `field` as validate() and check_outlines()
    /// do, and, with coordinates, for columns that pass a corner, lie on a clamped part, on each other, or turn by more
    /// than most_column_turn.
    SectionGeometry(const Section& section, int columns, double ds, const std::string& field = "section");

    /// The outside first, then the holes.
    const std::vector<ClosedCurve>& curves() const { return curves_; }
    /// Which of them carries the columns.
    std::size_t carrier_index() const { return carrier_; }
    const ClosedCurve& carrier() const { return curves_[carrier_]; }

    int columns() const { return columns_; }
    double ds() const { return ds_; }
    /// Arc length of the carrier at which a column begins, or the last one ends (column = columns()). It is in
    /// [0, length) of the first column, and exceeds the length where columns pass the start of the outline.
    double begin_of(int column) const { return first_ + column * ds_; }
    /// Length of the carrier where it has no corner, so that columns may lie on it all round; otherwise 0.
    double perimeter() const;
    /// Whether the body has a convex corner at this arc length of the carrier, but for rounding.
    bool is_edge(double s) const;

    /// At the midpoints of the columns.
    std::vector<ColumnFrame> frames() const;

   private:
    std::vector<ClosedCurve> curves_;
    std::size_t carrier_ = 0;
    int columns_;
    double ds_;
    double first_ = 0;
};

}  // namespace contactd::geometry
