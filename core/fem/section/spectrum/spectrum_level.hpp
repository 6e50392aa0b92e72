// Chooses mesh and wavenumbers for an accuracy, and predicts their cost.
#pragma once

#include "section/boundary_edges.hpp"

namespace contactd::fem {

/// Measurements on rails, edges, grooves and layers showed that these values are sufficient (docs/sections.md).
struct SpectrumLevel {
    int order, edges_a_strip, nodes;
    double corner_share;
};

/// Returns the level that is tried first; `nu` near 0.5 requires finer meshes of order 4 or higher.
SpectrumLevel first_level(double accuracy, double nu);

/// Returns the mesh with which build_spectrum begins for an accuracy. The order of its elements grows first, then their
/// number.
MeshDensity density_for(double accuracy, double nu);

/// Predicts the cost of the first level from the divided outline alone. For eighteen sections of all kinds, predicted
/// unknowns were between 1 and 1.4 times those of gmsh's mesh. For seven, predicted memory was between 1.05 and 1.3
/// times that of builders.
struct SpectrumSize {
    double unknowns = 0;
    double model_bytes = 0;     ///< per process: matrices and factors, including those of the next order
    double spectrum_bytes = 0;  ///< per process: the transform, and results derived from it
};
SpectrumSize predicted_spectrum(const SectionOutline& outline, double nu, double accuracy);

}  // namespace contactd::fem
