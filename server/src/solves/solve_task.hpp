// One contact problem on its way through the daemon: first the tables of its bodies, then a worker.
#pragma once

#include <functional>
#include <memory>

#include "contactd/observer.hpp"
#include "contactd/solve_reply.hpp"
#include "engine/engine.hpp"
#include "jobs/call.hpp"
#include "jobs/work_budget.hpp"
#include "recent_solves.hpp"

namespace contactd::server {

/// The parts of the daemon that solve.
struct SolveTools {
    engine::Engine& engine;
    WorkerPool& workers;
    RecentSolves& recent;
    WorkBudget& budget;
};

struct SolveTask {
    CallPtr call;              ///< hears of builds, and ends the solve by having been answered
    ContactProblem problem;    ///< valid
    std::shared_ptr<Job> job;  ///< ends the solve by being cancelled
    std::function<void(const Progress&)> progress;
    /// One of them is called, from any thread; what `done` throws goes to `failed`.
    std::function<void(const SolveReply&)> done;
    std::function<void(const proto::Status&)> failed;
    double bytes = 0;  ///< that the call holds, and gives back while it waits for a build; 0: those of others, too
    bool in_caller = false;  ///< the calling thread, a worker, may solve it itself
};

/// Returns at once, unless the task is solved by the caller.
void start(const SolveTools& tools, SolveTask task);

}  // namespace contactd::server
