// Influence coefficients of half-spaces that creep as they roll: what was loaded before has yielded more.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/axis.hpp"
#include "contactd/body.hpp"
#include "contactd/grid.hpp"
#include "contactd/observer.hpp"
#include "influence/shifted_table.hpp"

namespace contactd {

/// A[i,j](k,l) of the pair of bodies (see pair_of) at offsets of both signs: along the rolling direction there is no
/// parity.
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

/// The part for a grid of nx x ny elements, which the table covers.
RollingTable cropped(const RollingTable& table, int nx, int ny);

/// Two half-spaces of the standard linear solid that roll along x.
struct RollingHalfSpaces {
    Bodies bodies;           ///< their sources are closed forms of half-spaces; a body may be elastic, or rigid
    double velocity = 1;     ///< (mm/s), > 0
    bool is_forward = true;  ///< along +x, else along -x
};

/// A_ve = A + f E, E(d) the integral over s from 0 to infinity of A(d + s) exp(-s/l)/l, l = velocity tau, d + s where a
/// particle at d was that long ago. Throws Cancelled when the observer, which is asked row by row, says so.
RollingTable rolling_table(const RollingHalfSpaces& half_spaces, const Grid& grid, const Observer& observer = {});

/// Returns those at the points `step` ahead of the elements (mm, > 0, in the rolling direction).
ShiftedTable rolling_table_ahead(const RollingHalfSpaces& half_spaces, const Grid& grid, double step,
                                 const Observer& observer = {});

/// By how much displacements change over a step.
ShiftedTable change_over_step(const RollingTable& now, const ShiftedTable& ahead);

}  // namespace contactd
