// Analyses the undeformed distance row by row, along x, for models of virtual penetration.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "contactd/grid.hpp"

namespace contactd {

/// Describes the part of a row below a threshold: its middle and half of its length (mm).
struct RowExtent {
    double middle = 0, half = 0;
};

/// Describes a row as a parabola least + curvature (x - middle)^2 (mm, 1/mm).
struct RowParabola {
    double middle = 0, least = 0, curvature = 0;
};

/// Bodies that touch at a point have larger curvatures (1/mm).
inline constexpr double least_across = 1e-4, least_along = 1e-7;

class DistanceRows {
   public:
    /// `distance` is h at the element centres, shape [ny, nx] (mm), and must outlive this object. The initial parabolas
    /// are those of depth 0.
    DistanceRows(const Grid& grid, std::span<const double> distance);
    /// Fits the parabolas to the part of each row that is less than `depth` (mm, 0 or more) above its least value.
    void take_parabolas(double depth);

    const Grid& grid() const { return grid_; }
    std::span<const double> row(int iy) const;
    double least() const { return least_; }  ///< least distance of the surface, also between centres
    const RowParabola& parabola(int iy) const { return parabolas_[static_cast<std::size_t>(iy)]; }
    /// Returns half the second derivative across of the least distances of rows (1/mm), next to the ends that of the
    /// row beside, or 0 with fewer than three rows.
    double curvature_across(int iy) const;
    /// Returns half the second derivatives along and across where the surfaces are nearest (1/mm), positive.
    std::array<double, 2> curvatures() const;
    int deepest_row() const { return deepest_row_; }
    std::size_t deepest_element() const { return deepest_element_; }

    /// Returns the extent from the first to the last element below the threshold (mm), extended to the crossings
    /// between elements, or nothing if no element is below.
    std::optional<RowExtent> below(int iy, double threshold) const;
    /// Returns the extent across, by the least distances of rows.
    std::optional<RowExtent> rows_below(double threshold) const;

   private:
    Grid grid_;
    std::span<const double> distance_;
    std::vector<int> lowest_;  // column of the least distance in each row
    std::vector<RowParabola> parabolas_;
    double least_ = 0;
    int deepest_row_ = 0;
    std::size_t deepest_element_ = 0;
};

}  // namespace contactd
