// Vectors of the loads on strips, and of the displacements observed there.
#pragma once

#include <vector>

#include "wave_matrices.hpp"

namespace contactd::fem {

/// Sparse columns, 3 I + i for direction i (along x, the tangent s, the outward normal n) of strip I.
struct SparseColumns {
    struct Entry {
        int row;
        double value;
    };
    std::vector<std::vector<Entry>> columns;
};

/// Forces of a unit traction along x, and along the tangent and the normal where they act, over each strip's arc.
SparseColumns strip_loads(const SectionOutline& outline, const SectionMesh& mesh, const WaveMatrices& matrices);

/// Displacement at the middle of each strip's arc, in the frame there.
SparseColumns strip_observations(const SectionOutline& outline, const SectionMesh& mesh, const WaveMatrices& matrices);

}  // namespace contactd::fem
