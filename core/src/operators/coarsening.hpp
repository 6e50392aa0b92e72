// Defines grids of half as many elements in a direction, on which solvers compute their first estimate.
#pragma once

#include <span>

#include "contactd/ic_table.hpp"
#include "influence/shifted_table.hpp"
#include "influence/viscoelastic/rolling_table.hpp"

namespace contactd {

/// Elements of the coarse grid represent 2 x 2 fine ones, or 1 x 2 or 2 x 1 if the grid is short in one direction. The
/// last coarse element may extend beyond the fine grid.
class Coarsening {
   public:
    Coarsening(int nx, int ny);

    bool useful() const { return factor_x_ * factor_y_ > 1; }  ///< false if the grid is already small

    /// Return the mean displacement over a coarse element for a unit traction on another, for the components xx, yy,
    /// zz, xy, yx and, if `coupled`, xz, yz, zx, zy.
    IcTable coarse(const IcTable& fine, bool coupled) const;
    ShiftedTable coarse(const ShiftedTable& fine) const;
    RollingTable coarse(const RollingTable& fine, bool coupled) const;
    void average(std::span<const double> fine, std::span<double> coarse) const;
    /// Interpolates bilinearly between centres, with constants beyond the outermost ones.
    void interpolate(std::span<const double> coarse, std::span<double> fine) const;
    /// Gives each fine element the value of its coarse element.
    void copy(std::span<const double> coarse, std::span<double> fine) const;
    int along_x() const { return factor_x_; }  ///< fine elements in a coarse one
    int along_y() const { return factor_y_; }

   private:
    int nx_, ny_, factor_x_, factor_y_, coarse_nx_, coarse_ny_;
};

}  // namespace contactd
