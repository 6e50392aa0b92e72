// Describes the points of displacements: offsets from the loaded element, and the lines between elements.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/ic_spec.hpp"

namespace contactd {

/// Holds offsets (first_x + k dx, first_y + l dy), 0 <= k < nx, 0 <= l < ny, from the centre of the load.
struct OffsetLattice {
    double first_x = 0, first_y = 0;
    int nx = 0, ny = 0;
    double dx = 0, dy = 0;

    std::size_t index(int k, int l) const {
        return static_cast<std::size_t>(l) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(k);
    }
};

/// Holds displacements at an offset for a unit traction over the loaded element; zx and zy are those of xz and yz with
/// the opposite sign, and yx is xy.
struct SurfaceCoefficients {
    double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;
};

/// Holds the lines x = constant and y = constant between elements seen from the points: for constant loads half an
/// element before and behind, for hat functions a whole one, and those through their apices.
struct EdgeLines {
    std::vector<double> x, y;

    EdgeLines(const OffsetLattice& offsets, LoadShape load_shape);

    /// These are the distances of edges from the origin: the least, but not below what can be distinguished from zero,
    /// and the largest.
    double least, largest;
};

}  // namespace contactd
