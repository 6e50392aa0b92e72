#include "influence/layered/shifted_layers.hpp"

#include <cmath>

#include "influence/layered/layered_table.hpp"

namespace contactd {
namespace {

using enum Axis;

/// Describes the shift along one axis, in elements. It is whole if it differs only by rounding errors.
struct Shift {
    double elements;
    bool whole;

    Shift(double shift, double size) : elements(shift / size), whole(std::abs(elements - std::round(elements)) < 1e-9) {
        if (whole) elements = std::round(elements);
    }
};

// Returns offsets of a table for a shift by whole elements, which requires a half or a quarter as many.
ShiftedTable from_table(const Layers& body, LoadShape load_shape, const Grid& grid, int along_x, int along_y,
                        const Observer& observer) {
    const IcTable table = layered_table(body, load_shape, grid.nx + std::abs(along_x), grid.ny + std::abs(along_y),
                                        grid.dx, grid.dy, observer);
    ShiftedTable result(grid.nx, grid.ny);
    for (const Axis i : {x, y})
        for (const Axis j : {x, y, z})
            for (int l = 1 - grid.ny; l < grid.ny; ++l)
                for (int k = 1 - grid.nx; k < grid.nx; ++k)
                    result(i, j, k, l) = table.at(i, j, k + along_x, l + along_y);
    return result;
}

}  // namespace

ShiftedTable shifted_layers(const Layers& body, LoadShape load_shape, const Grid& grid, double shift_x, double shift_y,
                            const Observer& observer) {
    const Shift along_x(shift_x, grid.dx), along_y(shift_y, grid.dy);
    if (along_x.whole && along_y.whole && std::abs(along_x.elements) <= grid.nx &&
        std::abs(along_y.elements) <= grid.ny)
        return from_table(body, load_shape, grid, static_cast<int>(along_x.elements),
                          static_cast<int>(along_y.elements), observer);
    // If rolling is along x, rows below are the mirrored rows above.
    const bool even = along_y.elements == 0;
    const int first_l = even ? 0 : 1 - grid.ny;
    const OffsetLattice offsets{.first_x = (1 - grid.nx + along_x.elements) * grid.dx,
                                .first_y = (first_l + along_y.elements) * grid.dy,
                                .nx = 2 * grid.nx - 1,
                                .ny = grid.ny - first_l,
                                .dx = grid.dx,
                                .dy = grid.dy};
    const auto values = layered_coefficients(body, load_shape, offsets, observer);
    ShiftedTable result(grid.nx, grid.ny);
    for (int l = first_l; l < grid.ny; ++l)
        for (int k = 1 - grid.nx; k < grid.nx; ++k) {
            SurfaceCoefficients at = values[offsets.index(k + grid.nx - 1, l - first_l)];
            if (even && l == 0) at.xy = at.yz = 0;
            result(x, x, k, l) = at.xx;
            result(y, y, k, l) = at.yy;
            result(x, y, k, l) = result(y, x, k, l) = at.xy;
            result(x, z, k, l) = at.xz;
            result(y, z, k, l) = at.yz;
            if (!even) continue;
            result(x, x, k, -l) = at.xx;
            result(y, y, k, -l) = at.yy;
            result(x, y, k, -l) = result(y, x, k, -l) = -at.xy;
            result(x, z, k, -l) = at.xz;
            result(y, z, k, -l) = -at.yz;
        }
    return result;
}

}  // namespace contactd
