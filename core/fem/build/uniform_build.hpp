// The record of a longitudinally uniform body: the transform of its coefficients.
#pragma once

#include <cstdint>
#include <string>

#include <mpi.h>

#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"

namespace contactd::fem {

/// Collective; wavenumbers are spread over the processes. `spec` must be dimensionless. Throws as build_ic_table does,
/// everything on all processes.
IcRecord build_uniform(MPI_Comm comm, const IcSpec& spec, Observer& observer, std::uint64_t max_memory_bytes);

/// The mesh of the section that build_uniform takes, lengths times `unit`: an unstructured grid of VTK.
std::string section_triangles(const IcSpec& spec, double unit);

}  // namespace contactd::fem
