// Computes the transform of a section's coefficients to a requested accuracy: chooses mesh, order and wavenumbers, and
// estimates their errors.
#pragma once

#include <cstdint>
#include <functional>

#include <mpi.h>

#include "collective_observer.hpp"
#include "contactd/strip_spectrum.hpp"
#include "section/boundary_edges.hpp"
#include "section_model.hpp"
#include "spectrum_level.hpp"

namespace contactd::fem {

/// Holds errors divided by error_scale() of elements of the same length, the largest of all lengths served.
struct SpectrumErrors {
    double mesh = 0;         ///< 1.5 times the difference from elements of the next order
    double wavenumbers = 0;  ///< an eighth of the effect of every other wavenumber
    double end = 0;          ///< bound of the part beyond the last wavenumber
    double reciprocity = 0;  ///< before symmetrisation, which changes a coefficient by half of it
    /// Returns the errors that finer meshes and more wavenumbers reduce.
    double numerical() const { return mesh + wavenumbers + end; }
    double total() const { return numerical() + reciprocity / 2; }
};

struct SpectrumBuild {
    StripSpectrum spectrum;
    SpectrumErrors errors;
    int order = 0;
    long long triangles = 0, unknowns = 0;
    double mesh_seconds = 0, setup_seconds = 0, solve_seconds = 0;
};

/// Collective; wavenumbers are distributed over the processes, and all get the result. `outline` and the frames of
/// `columns` have lengths divided by ds. Throws InvalidArgument if no mesh can be made; OutOfMemory if the analysis of
/// the matrix predicts more than `max_memory_bytes` for all processes together (0: no limit); NotConverged if nothing
/// holds the body or the finest choice misses the accuracy; and Cancelled. The defect of reciprocity, which no mesh
/// reduces, may exceed the accuracy; `errors` contains it.
SpectrumBuild build_spectrum(MPI_Comm comm, const SectionOutline& outline, double nu, double accuracy,
                             Observer& observer, std::uint64_t max_memory_bytes = 0);

/// Returns the frames of the strips, with lengths divided by ds and continuous angles.
std::vector<StripFrame> strip_frames(const SectionOutline& outline);

}  // namespace contactd::fem
