// Work that one process does while the others wait without using processor time, as MPI's own waiting does.
#pragma once

#include <functional>
#include <string>

#include <mpi.h>

#include "contactd/ic_store.hpp"

namespace contactd::fem {

/// `text` of the first process on all of them; who waits for it sleeps. Collective.
std::string quiet_broadcast(MPI_Comm comm, std::string text);

/// `build` on the first process; its record, or its InvalidArgument, NotConverged or Cancelled, on all of them. Other
/// exceptions come on the first process alone. Collective.
IcRecord on_first_process(MPI_Comm comm, const std::function<IcRecord()>& build);

}  // namespace contactd::fem
