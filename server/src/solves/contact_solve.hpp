// contact.solve and contact.solve_many.
#pragma once

#include "jobs/call.hpp"
#include "solve_task.hpp"

namespace contactd::server {

/// Answers `call` when the solve has ended. Throws for a problem that cannot be solved as stated.
void start_solve(const CallPtr& call, const SolveTools& tools);

/// Answers `call` when all solves have ended; what cannot be solved fails alone. `threads` of them run at a time, so
/// that other requests get their turn in between.
void start_solve_many(const CallPtr& call, const SolveTools& tools, int threads, const MessageLimits& limits);

}  // namespace contactd::server
