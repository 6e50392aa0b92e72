// Runs work on one process while the others wait without using processor time, unlike MPI's own waiting.
#pragma once

#include <functional>
#include <string>

#include <mpi.h>

#include "contactd/ic_store.hpp"

namespace contactd::fem {

/// Returns the `text` of the first process on all processes; waiting processes sleep. Collective.
std::string quiet_broadcast(MPI_Comm comm, std::string text);

/// Runs `build` on the first process. All processes get its record, or its InvalidArgument, NotConverged or Cancelled.
/// Other exceptions occur on the first process only. Collective.
IcRecord on_first_process(MPI_Comm comm, const std::function<IcRecord()>& build);

}  // namespace contactd::fem
