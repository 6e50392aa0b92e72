// Computes influence coefficients of rolling viscoelastic half-spaces, in which earlier loads have larger
// displacements.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/axis.hpp"
#include "contactd/body.hpp"
#include "contactd/grid.hpp"
#include "contactd/observer.hpp"
#include "influence/shifted_table.hpp"

namespace contactd {

/// Holds A[i,j](k,l) of the pair of bodies (see pair_of) at offsets of both signs: along the rolling direction there is
/// no parity.
struct RollingTable {
    int nx = 0;                  ///< offsets -(nx-1)..nx-1 along x
    int ny = 0;                  ///< offsets -(ny-1)..ny-1 along y
    std::vector<double> values;  ///< shape [3, 3, 2 ny - 1, 2 nx - 1]: displacement axis, load axis, l, k; mm^3/N

    RollingTable() = default;
    RollingTable(int nx_, int ny_) : nx(nx_), ny(ny_), values(9 * component_size()) {}

    std::size_t component_size() const {
        return static_cast<std::size_t>(2 * nx - 1) * static_cast<std::size_t>(2 * ny - 1);
    }
    std::size_t index(Axis i, Axis j, int k, int l) const {
        return (static_cast<std::size_t>(i) * 3 + static_cast<std::size_t>(j)) * component_size() +
               static_cast<std::size_t>(l + ny - 1) * static_cast<std::size_t>(2 * nx - 1) +
               static_cast<std::size_t>(k + nx - 1);
    }
    double& operator()(Axis i, Axis j, int k, int l) { return values[index(i, j, k, l)]; }
    double operator()(Axis i, Axis j, int k, int l) const { return values[index(i, j, k, l)]; }
};

/// Returns the part for a grid of nx x ny elements, which the table covers.
RollingTable cropped(const RollingTable& table, int nx, int ny);

/// Describes two half-spaces of the standard linear solid that roll along x.
struct RollingHalfSpaces {
    Bodies bodies;           ///< their sources are closed forms of half-spaces; a body may be elastic, or rigid
    double velocity = 1;     ///< (mm/s), > 0
    bool is_forward = true;  ///< along +x, otherwise along -x
};

/// Returns A_ve = A + f E, where E(d) is the integral over s from 0 to infinity of A(d + s) exp(-s/l)/l, l = velocity
/// tau, with d + s the position at that time of a particle now at d. Throws Cancelled if the observer, which is called
/// for each row, cancels.
RollingTable rolling_table(const RollingHalfSpaces& half_spaces, const Grid& grid, const Observer& observer = {});

/// Returns the coefficients at the points `step` ahead of the elements (mm, > 0, in the rolling direction).
ShiftedTable rolling_table_ahead(const RollingHalfSpaces& half_spaces, const Grid& grid, double step,
                                 const Observer& observer = {});

/// Returns the change of displacements over a step.
ShiftedTable change_over_step(const RollingTable& now, const ShiftedTable& ahead);

}  // namespace contactd
