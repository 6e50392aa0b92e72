// What columns load, and what is observed of them.
#pragma once

#include <vector>

#include "wave_matrices.hpp"

namespace contactd::fem {

/// Sparse columns, 3 I + i for direction i (along x, the tangent s, the outward normal n) of column I.
struct SparseColumns {
    struct Entry {
        int row;
        double value;
    };
    std::vector<std::vector<Entry>> columns;
};

/// Forces of a unit traction along x, and along the tangent and the normal where they act, over each column's arc.
SparseColumns column_loads(const SectionOutline& outline, const SectionMesh& mesh, const WaveMatrices& matrices);

/// Displacement at the middle of each column's arc, in the frame there.
SparseColumns column_observations(const SectionOutline& outline, const SectionMesh& mesh, const WaveMatrices& matrices);

}  // namespace contactd::fem
