// Builds the record of a longitudinally uniform body: the transform of its coefficients.
#pragma once

#include <cstdint>
#include <string>

#include <mpi.h>

#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"

namespace contactd::fem {

/// Collective; wavenumbers are distributed over the processes. `spec` must be dimensionless. Throws as build_ic_table
/// does, on all processes.
IcRecord build_uniform(MPI_Comm comm, const IcSpec& spec, Observer& observer, std::uint64_t max_memory_bytes);

/// Returns the mesh of the section that build_uniform uses, with lengths times `unit`, as an unstructured grid of VTK.
std::string section_triangles(const IcSpec& spec, double unit);

}  // namespace contactd::fem
