// The undeformed distance row by row, as models of virtual penetration look at it: rows lie along x.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contactd/grid.hpp"

namespace contactd {

/// Where a row lies below a threshold: the middle and half of the length (mm).
struct RowExtent {
    double middle = 0, half = 0;
};

/// A row as a parabola least + curvature (x - middle)^2 (mm, 1/mm).
struct RowParabola {
    double middle = 0, least = 0, curvature = 0;
};

class DistanceRows {
   public:
    /// `distance` is h at the element centres, shape [ny, nx] (mm); `depth` is how far above its least value the rows
    /// are looked at (mm), 0 or more.
    DistanceRows(const Grid& grid, std::span<const double> distance, double depth);

    const Grid& grid() const { return grid_; }
    std::span<const double> row(int iy) const;
    double least() const { return least_; }  ///< of the surface, between centres too
    const RowParabola& parabola(int iy) const { return parabolas_[static_cast<std::size_t>(iy)]; }
    int deepest_row() const { return deepest_row_; }
    std::size_t deepest_element() const { return deepest_element_; }

    /// From the first to the last element below the threshold (mm), and on to where it is crossed between elements;
    /// nothing where no element is below.
    std::optional<RowExtent> below(int iy, double threshold) const;
    /// Returns that across, by the least distances of rows.
    std::optional<RowExtent> rows_below(double threshold) const;

   private:
    Grid grid_;
    std::vector<double> distance_;
    std::vector<RowParabola> parabolas_;
    double least_ = 0;
    int deepest_row_ = 0;
    std::size_t deepest_element_ = 0;
};

}  // namespace contactd
