// Computes influence coefficients by finite elements. This is the only public header of contactd::fem. Functions marked
// "Collective" must be called by all processes of MPI_COMM_WORLD.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contactd/ic_store.hpp"
#include "contactd/observer.hpp"

namespace contactd::fem {

/// Initialises MPI and hypre for the lifetime of this object, of which a program has one. BLAS and OpenMP get one
/// thread each unless the environment (OMP_NUM_THREADS, OPENBLAS_NUM_THREADS) sets another number. MPI is called only
/// from the thread that created the object.
class Runtime {
   public:
    Runtime(int& argc, char**& argv);
    ~Runtime();
    Runtime(const Runtime&) = delete;
    Runtime& operator=(const Runtime&) = delete;

    int rank() const { return rank_; }
    int processes() const { return processes_; }
    /// Returns the ranks of all processes of this run on this machine, in the same order on each of them. Collective.
    std::vector<int> processes_here() const;
    /// Returns `text` of the first process on all processes; waiting processes sleep. Collective.
    std::string broadcast(std::string text) const;
    /// Ends all processes at once, for a failure that may occur on one process only.
    [[noreturn]] void abort(int exit_code) const;

   private:
    int rank_ = 0;
    int processes_ = 1;
};

/// Returns the versions of contactd and of the libraries that make finite-element tables, as in IcEvidence::version.
std::string fem_version();

/// Predicts the largest resident memory (bytes) of all processes together while the table of `spec` is built. It is
/// accurate within a factor of 1.5 on measured meshes, and of two on sections. Throws as build_ic_table does. A Runtime
/// must exist.
double predicted_memory(const IcSpec& spec);

/// Builds the dimensionless table of `spec` (source fem): mesh, one assembly, three load cases, sampling, comparison
/// with the closed form. With dx = dy the y case is the mirrored x case and is not solved again. Every process gets the
/// same record. Only the first process reports progress, and only its observer can cancel. A Runtime must exist.
/// Collective.
///
/// If the equations are factorised or the mesh is adaptive, the first of several processes builds alone while the
/// others sleep; `evidence.processes` is then 1. Throws InvalidArgument for a spec that cannot be meshed, OutOfMemory
/// if the processes together are predicted to need more than `max_memory_bytes` (0: no limit), NotConverged if a load
/// case misses its tolerance, and Cancelled, each on all processes. Errors of the libraries (std::exception) may occur
/// on one process alone.
IcRecord build_ic_table(const IcSpec& spec, Observer& observer, std::uint64_t max_memory_bytes = 0);

/// Returns a VTK file for viewing, with the triangles (mm) of the cross-section on which the table of `spec`, of a
/// longitudinally uniform body, is built. Throws InvalidArgument as build_ic_table does, and "ics.body" for any other
/// body.
std::string section_mesh(const IcSpec& spec);

}  // namespace contactd::fem
