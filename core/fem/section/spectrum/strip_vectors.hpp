// Assembles vectors of the loads on strips, and of the displacements observed there.
#pragma once

#include <vector>

#include "wave_matrices.hpp"

namespace contactd::fem {

/// Holds sparse columns, 3 I + i for direction i (along x, the tangent s, the outward normal n) of strip I.
struct SparseColumns {
    struct Entry {
        int row;
        double value;
    };
    std::vector<std::vector<Entry>> columns;
};

/// Returns forces of a unit traction along x, and along the local tangent and normal, over each strip's arc.
SparseColumns strip_loads(const SectionOutline& outline, const SectionMesh& mesh, const WaveMatrices& matrices);

/// Returns the displacement at the middle of each strip's arc, in the frame there.
SparseColumns strip_observations(const SectionOutline& outline, const SectionMesh& mesh, const WaveMatrices& matrices);

}  // namespace contactd::fem
