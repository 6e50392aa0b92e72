// Mesh and wavenumbers for an accuracy, and their cost.
#pragma once

#include "section/boundary_edges.hpp"

namespace contactd::fem {

/// Found good by measurement on rails, edges, grooves and layers (docs/sections.md).
struct SpectrumLevel {
    int order, edges_a_strip, nodes;
    double corner_share;
};

/// That is tried first; `nu` near 0.5 takes finer meshes of order 4 at least.
SpectrumLevel first_level(double accuracy, double nu);

/// The mesh that build_spectrum begins with for an accuracy: the order of its elements grows first, then their number.
MeshDensity density_for(double accuracy, double nu);

/// At the first level, from the divided outline alone: of eighteen sections of all kinds unknowns came out between 1
/// and 1.4 times those of gmsh's mesh, of seven memory between 1.05 and 1.3 times what builders took.
struct SpectrumSize {
    double unknowns = 0;
    double model_bytes = 0;     ///< of a process: matrices and factors, of the next order, too
    double spectrum_bytes = 0;  ///< of a process: the transform, and what is made of it
};
SpectrumSize predicted_spectrum(const SectionOutline& outline, double nu, double accuracy);

}  // namespace contactd::fem
