// A section as curves: its outline and holes by arc length, and the columns on one of them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "contactd/section.hpp"
#include "geometry/section/closed_curve.hpp"

namespace contactd::geometry {

/// What is checked: outlines are closed, neither cross themselves nor each other, and have the body on their right;
/// columns lie on their curve, where nothing is held, across no corner, beside each other, and a hollow's radius is
/// more than their width.
class SectionGeometry {
   public:
    /// Throws InvalidArgument below `field` with coordinates of what is wrong. `ds` is the arc length of a column (mm).
    SectionGeometry(const Section& section, int columns, double ds, const std::string& field = "section");

    /// The outside first, then the holes.
    const std::vector<ClosedCurve>& curves() const { return curves_; }
    /// Which of them carries the columns.
    std::size_t carrier_index() const { return carrier_; }
    const ClosedCurve& carrier() const { return curves_[carrier_]; }

    int columns() const { return columns_; }
    double ds() const { return ds_; }
    /// Arc length of the carrier at which a column begins, or the last one ends (column = columns()). From 0 on, it
    /// exceeds the carrier's length where columns pass the start of the outline.
    double begin_of(int column) const { return first_ + column * ds_; }

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
