// Solves one contact problem in the daemon: first the tables of its bodies are fetched, then a worker solves it.
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

/// Refers to the parts of the daemon needed for solves.
struct SolveTools {
    engine::Engine& engine;
    WorkerPool& workers;
    RecentSolves& recent;
    WorkBudget& budget;
};

struct SolveTask {
    CallPtr call;              ///< receives progress of builds; the solve ends if it is answered
    ContactProblem problem;    ///< valid
    std::shared_ptr<Job> job;  ///< the solve ends if it is cancelled
    std::function<void(const Progress&)> progress;
    /// Exactly one of them is called, from any thread; exceptions of `done` go to `failed`.
    std::function<void(const SolveReply&)> done;
    std::function<void(const proto::Status&)> failed;
    double bytes = 0;  ///< bytes that the call holds, and releases while it waits for a build; 0: shared with others
    bool in_caller = false;  ///< true if the calling thread is a worker that may solve it
};

/// Returns immediately, unless the calling thread solves the task.
void start(const SolveTools& tools, SolveTask task);

}  // namespace contactd::server
