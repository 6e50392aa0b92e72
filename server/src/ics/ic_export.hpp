// ic.export: fetch the coefficients of one body or of two, then make a file of them on a worker.
#pragma once

#include "ic_service.hpp"
#include "jobs/call.hpp"
#include "jobs/worker_pool.hpp"

namespace contactd::server {

/// Answers `call` now (bad request) or when the file is made. Throws for a request that cannot be met: bad parameters,
/// or a text of more than `most_bytes`.
void start_export(const CallPtr& call, IcService& ics, WorkerPool& workers, std::size_t most_bytes);

}  // namespace contactd::server
