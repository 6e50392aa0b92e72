// Influence coefficients by finite elements: the one entry of contactd::fem. Collective over MPI_COMM_WORLD.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contactd/ic_store.hpp"
#include "contactd/observer.hpp"

namespace contactd::fem {

/// MPI and hypre, initialised for the lifetime of this object; one per program. BLAS and OpenMP get one thread each
/// unless the environment (OMP_NUM_THREADS, OPENBLAS_NUM_THREADS) says otherwise. MPI is called from the thread that
/// made the object only.
class Runtime {
   public:
    Runtime(int& argc, char**& argv);
    ~Runtime();
    Runtime(const Runtime&) = delete;
    Runtime& operator=(const Runtime&) = delete;

    int rank() const { return rank_; }
    int processes() const { return processes_; }
    /// Process numbers of all processes of this run on this machine, the same in the same order on each. Collective.
    std::vector<int> processes_here() const;
    /// `text` of the first process on all of them; who waits for it sleeps. Collective.
    std::string broadcast(std::string text) const;
    /// Ends all processes at once; for a failure the others may not share.
    [[noreturn]] void abort(int exit_code) const;

   private:
    int rank_ = 0;
    int processes_ = 1;
};

/// contactd and the libraries that make finite-element tables, as in IcEvidence::version.
std::string fem_version();

/// Largest resident memory (bytes), of all processes together, that building the table of `spec` is expected to take;
/// within a factor of 1.5 on meshes that were measured, of two on sections. Throws as build_ic_table does. A Runtime
/// must exist.
double predicted_memory(const IcSpec& spec);

/// Builds the dimensionless table of `spec` (source fem): mesh, one assembly, three load cases, sampling, comparison
/// with the closed form. With dx = dy the y case is the x case mirrored and not solved again. Every process gets the
/// same record. Progress comes on the first process only, where the observer's cancelled() counts too. A Runtime must
/// exist.
/// The first of several processes builds alone, and the others sleep, where the equations are factorised or the
/// mesh is adaptive; `evidence.processes` is 1 then. Throws InvalidArgument for a spec that cannot be meshed,
/// OutOfMemory when the processes together would need more than `max_memory_bytes` (0: no limit) by all that is known
/// before, NotConverged when a load case misses its tolerance and Cancelled, each on all processes; errors of the
/// libraries (std::exception) may come on one process alone.
IcRecord build_ic_table(const IcSpec& spec, Observer& observer, std::uint64_t max_memory_bytes = 0);

/// The triangles (mm) of the cross-section that the table of `spec`, of a longitudinally uniform body, is built on, as
/// a file of VTK: to look at. Throws InvalidArgument as build_ic_table does, and "ics.body" for any other body.
std::string section_mesh(const IcSpec& spec);

}  // namespace contactd::fem
