// Orders the elements of a grid as lines along the rolling direction, each from the leading edge backwards.
#pragma once

#include <cstddef>

#include "closed_forms/rolling_frame.hpp"
#include "contactd/grid.hpp"

namespace contactd {

class ElementLines {
   public:
    /// Throws InvalidArgument ("friction.rolling.chi") if the rolling direction is not an axis of the grid.
    ElementLines(const Grid& grid, const RollingFrame& frame);

    int count() const { return rows_ ? grid_.ny : grid_.nx; }
    int length() const { return rows_ ? grid_.nx : grid_.ny; }
    double step() const { return rows_ ? grid_.dx : grid_.dy; }   ///< size of an element along the lines (mm)
    double width() const { return rows_ ? grid_.dy : grid_.dx; }  ///< size of an element across the lines (mm)

    /// Returns the index of an element in arrays over the grid; place 0 is at the leading edge.
    std::size_t element(int line, int place) const;
    /// Return coordinates of centres in the frame of rolling (mm).
    double along(int place) const;
    double across(int line) const;

   private:
    int cell(int place) const { return forwards_ ? length() - 1 - place : place; }

    Grid grid_;
    RollingFrame frame_;
    bool rows_ = true, forwards_ = true;
};

}  // namespace contactd
