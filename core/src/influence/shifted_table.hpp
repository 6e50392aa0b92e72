// Computes influence coefficients at points some distance away from the element centres, where rolling particles were.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "contactd/axis.hpp"
#include "contactd/grid.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Holds A'[i,j](k,l) = A[i,j](k + shift_x/dx, l + shift_y/dy) of the pair of bodies (see pair_of). It is the
/// tangential displacement i (mm) at the point that lies (shift_x, shift_y) from the centre of the element whose offset
/// from the loaded one is (k,l), for a unit traction along j. There is no parity: offsets have both signs.
struct ShiftedTable {
    int nx = 0;                  ///< offsets -(nx-1)..nx-1 along x
    int ny = 0;                  ///< offsets -(ny-1)..ny-1 along y
    std::vector<double> values;  ///< shape [2, 3, 2 ny - 1, 2 nx - 1]: i = x, y; j = x, y, z; l; k; mm^3/N

    ShiftedTable() = default;
    ShiftedTable(int nx_, int ny_) : nx(nx_), ny(ny_), values(6 * component_size()) {}

    std::size_t component_size() const {
        return static_cast<std::size_t>(2 * nx - 1) * static_cast<std::size_t>(2 * ny - 1);
    }
    std::size_t index(Axis i, Axis j, int k, int l) const {
        return (static_cast<std::size_t>(i) * 3 + static_cast<std::size_t>(j)) * component_size() +
               static_cast<std::size_t>(l + ny - 1) * static_cast<std::size_t>(2 * nx - 1) +
               static_cast<std::size_t>(k + nx - 1);
    }
    double& operator()(Axis i, Axis j, int k, int l) { return values[index(i, j, k, l)]; }  ///< i = x or y
    double operator()(Axis i, Axis j, int k, int l) const { return values[index(i, j, k, l)]; }
};

/// Returns the part for a grid of nx x ny elements. Throws InvalidArgument if the table is smaller.
ShiftedTable cropped(const ShiftedTable& table, int nx, int ny);

/// Describes two half-spaces under loads of one shape.
struct HalfSpaces {
    MaterialPair bodies;
    LoadShape load_shape = LoadShape::constant;
    std::optional<LineContactSpec> line_contact{};
};

/// Returns the closed form. Of `grid` only the numbers and the sizes of the elements matter. The absolute accuracy is
/// 1e-13 (bilinear load 1e-12) of the largest coefficient. Throws Cancelled if the observer, which is called for each
/// row, cancels.
ShiftedTable shifted_half_spaces(const HalfSpaces& half_spaces, const Grid& grid, double shift_x, double shift_y,
                                 const Observer& observer = {});

/// Returns coefficients from a table of the pair, with element sizes dx and dy of `grid` and at least the grid's
/// extent.
///
/// A shift by whole elements uses the table's own numbers. For other shifts, the difference to the closed form of
/// `nearest` is interpolated (cubic, with the parity of the component) and added to the closed form at the shifted
/// point. `nearest` are the half-spaces of the bodies' materials, whether or not the bodies are half-spaces, because
/// they have the same singularity under the load. If the materials are unknown (no `nearest`), the half-spaces with the
/// same singularity are fitted to the table, by least squares near the origin. A shift by one element exceeds a table
/// with the grid's extent. Beyond its end, the difference is extrapolated linearly in 1/rho, so it stays bounded; a
/// larger table needs less extrapolation.
///
/// Errors are relative to the largest coefficient. Half-spaces have none, except rounding if known, and 1e-9 if fitted.
/// A thin layer, modelled as half-spaces minus an image at twice its thickness of 2 dx, has 5e-5 with `nearest` and
/// 4e-4 without it at half and third elements, and 1e-5 where a table of 20 x 20 offsets ends (tested in
/// tests/core/influence/test_shifted_table.cpp). The roughness of a computed table from offset to offset remains in the
/// result. Throws InvalidArgument ("grid") if the table is smaller than the grid, and Cancelled.
ShiftedTable shifted_table(const IcTable& pair, const std::optional<HalfSpaces>& nearest, const Grid& grid,
                           double shift_x, double shift_y, const Observer& observer = {});

/// Returns C = A - A', with A' the coefficients one step ahead: the change in a step of rolling (StepOperator).
/// Components are xx, xy, yx, yy as in the friction law, and xz, yz for the pressure's part of the rigid slip. Throws
/// InvalidArgument if `pair` is smaller than `ahead`.
ShiftedTable change_over_step(const IcTable& pair, const ShiftedTable& ahead);

}  // namespace contactd
