// The undeformed distance row by row, as models of virtual penetration look at it: rows lie along x.
#pragma once

#include <array>
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

/// Curvatures below are not those of a body that touches at a point (1/mm).
inline constexpr double least_across = 1e-4, least_along = 1e-7;

class DistanceRows {
   public:
    /// `distance` is h at the element centres, shape [ny, nx] (mm), and outlives this. Parabolas are those of depth 0.
    DistanceRows(const Grid& grid, std::span<const double> distance);
    /// Makes the parabolas of what lies less than `depth` (mm, 0 or more) above the least value of each row.
    void take_parabolas(double depth);

    const Grid& grid() const { return grid_; }
    std::span<const double> row(int iy) const;
    double least() const { return least_; }  ///< of the surface, between centres too
    const RowParabola& parabola(int iy) const { return parabolas_[static_cast<std::size_t>(iy)]; }
    /// Half the second derivative across of the least distances of rows (1/mm), next to the ends that of the row
    /// beside; 0 where there are fewer than three rows.
    double curvature_across(int iy) const;
    /// Half the second derivatives along and across where the surfaces are nearest (1/mm), positive.
    std::array<double, 2> curvatures() const;
    int deepest_row() const { return deepest_row_; }
    std::size_t deepest_element() const { return deepest_element_; }

    /// From the first to the last element below the threshold (mm), and on to where it is crossed between elements;
    /// nothing where no element is below.
    std::optional<RowExtent> below(int iy, double threshold) const;
    /// Returns that across, by the least distances of rows.
    std::optional<RowExtent> rows_below(double threshold) const;

   private:
    Grid grid_;
    std::span<const double> distance_;
    std::vector<int> lowest_;  // the column of each row where it is nearest
    std::vector<RowParabola> parabolas_;
    double least_ = 0;
    int deepest_row_ = 0;
    std::size_t deepest_element_ = 0;
};

}  // namespace contactd
