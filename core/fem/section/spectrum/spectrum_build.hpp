// The transform of a section's coefficients to the accuracy asked for: mesh, order and wavenumbers chosen, with what
// their errors are.
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

/// Errors over error_scale() of elements of the same length, the largest of all that are served.
struct SpectrumErrors {
    double mesh = 0;         ///< half as much again as the difference to elements of the next order
    double wavenumbers = 0;  ///< an eighth of what every other wavenumber changes
    double end = 0;          ///< what may lie beyond the last wavenumber
    double reciprocity = 0;  ///< before the transform was made symmetric, which moves a coefficient by half of it
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

/// Collective; wavenumbers are spread over the processes, and every one gets the result. `outline` and the frames of
/// `columns` have lengths over ds. Throws InvalidArgument when no mesh can be made, OutOfMemory when the processes
/// together would need more than `max_memory_bytes` (0: no limit) as the analysis of the matrix predicts, NotConverged
/// when nothing holds the body or the finest choice misses the accuracy, and Cancelled. The defect of reciprocity,
/// which no mesh makes less, may be more than the accuracy; `errors` has it.
SpectrumBuild build_spectrum(MPI_Comm comm, const SectionOutline& outline, double nu, double accuracy,
                             Observer& observer, std::uint64_t max_memory_bytes = 0);

/// Returns the frames of the strips, lengths over ds; angles run on continuously.
std::vector<StripFrame> strip_frames(const SectionOutline& outline);

}  // namespace contactd::fem
