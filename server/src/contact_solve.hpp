// contact.solve: fetch the coefficients of both bodies, then solve on a worker.
#pragma once

#include <functional>

#include "call.hpp"
#include "ic_service.hpp"
#include "job.hpp"
#include "worker_pool.hpp"

namespace contactd::server {

/// Answers `call` now (bad problem) or when the solve has ended. Throws for a problem that cannot be solved as stated.
void start_solve(const CallPtr& call, IcService& ics, WorkerPool& workers, JobTable& jobs);

/// Runs `work`; what it throws becomes the answer of the call.
void guarded(const CallPtr& call, const std::function<void()>& work);

nlohmann::json to_json(const Job& job, const JobProgress& progress);

}  // namespace contactd::server
