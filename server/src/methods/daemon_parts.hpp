// Holds the parts of the daemon that methods use.
#pragma once

#include "config/config.hpp"
#include "contact_files/file_runs.hpp"
#include "engine/engine.hpp"
#include "jobs/open_calls.hpp"
#include "jobs/work_budget.hpp"
#include "operation/counters.hpp"
#include "operation/health.hpp"
#include "operation/host.hpp"
#include "operation/metrics/metrics.hpp"
#include "sessions/session_table.hpp"
#include "solves/solve_task.hpp"

namespace contactd::server {

/// Refers to the parts of the daemon, which Service owns.
struct DaemonParts {
    const Config& config;
    const Host& host;
    OpenCalls& open_calls;
    Counters& counters;
    RequestMetrics& request_metrics;
    Health& health;
    engine::Engine& engine;
    engine::IcService& ics;  ///< jobs of the engine
    engine::JobTable& jobs;
    SessionTable& sessions;
    RecentSolves& recent_solves;
    FileRuns& file_runs;
    WorkerPool& workers;
    WorkBudget& budget;
    const Call::Clock::time_point started = Call::Clock::now();

    SolveTools solve_tools() const { return {engine, workers, recent_solves, budget}; }
    /// Counts an outgoing answer. Only one thread at a time may call it.
    void note(const Answer& answer) const {
        if (answer.status != "OK") ++counters.requests_failed;
        request_metrics.record(answer);
        open_calls.close(answer.number);
    }
    /// Drops waiting work of answered calls.
    void drop_abandoned() const {
        workers.drop_abandoned();
        sessions.drop_abandoned();
        ics.drop_abandoned();
        budget.drop_abandoned();
    }
};

}  // namespace contactd::server
