// Builds tables: waits for their turn among the builds of this process and others, runs the builder, and reports the
// result.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contactd/table_lock.hpp"
#include "engine/ics/build/build_quarantine.hpp"
#include "engine/ics/build/builder.hpp"
#include "engine/ics/store/resilient_store.hpp"
#include "engine/jobs/job.hpp"
#include "engine/jobs/worker_pool.hpp"
#include "engine/operation/engine_counters.hpp"
#include "engine/operation/engine_log.hpp"

namespace contactd::engine {

/// Holds a requested table and its callbacks. Exactly one of `done`, `failed` and `cancelled` is called, unless the job
/// is cancelled before the build begins. All are called from the threads of IcBuilds.
struct TableBuild {
    IcSpec spec;  ///< dimensionless
    std::string key;
    std::shared_ptr<Job> job;
    std::function<void(const JobProgress&)> report;
    std::function<void(ResilientStore::Record, const char* origin)> done;  ///< "built", or "disk" where others built it
    std::function<void(const proto::Status&)> failed;
    std::function<void()> cancelled;
    std::function<std::vector<std::string>()> keys_in_use;  ///< keys of tables that are not evicted for this one
};

/// Thread-safe. Repeatable failures are put into quarantine.
class IcBuilds {
   public:
    struct Settings {
        BuilderCommand command;
        int concurrent = 1;
        BuildQuarantine::Settings quarantine = {};
    };
    /// All three must outlive this object.
    IcBuilds(Settings settings, ResilientStore& resilient_store, EngineCounters& counters, const EngineLog& log);

    void queue(QueueTicket ticket, TableBuild build);
    /// Waits for running builds, whose jobs were cancelled. No build begins afterwards.
    void stop() { builders_.stop(); }

    BuildQuarantine& quarantine() { return quarantine_; }
    int waiting() const { return builders_.waiting(); }
    int running() const { return builders_.running(); }

   private:
    void run(const TableBuild& build);
    void wait_for_lock(const TableBuild& build, TableLock& lock);
    ResilientStore::Record run_builder(const TableBuild& build, const TableLock& lock);
    void fail(const TableBuild& build, const proto::Status& status);

    const Settings settings_;
    ResilientStore& resilient_store_;
    EngineCounters& counters_;
    const EngineLog& log_;
    BuildQuarantine quarantine_;
    WorkerPool builders_;  // is destroyed first, because its threads use everything above
};

/// Returns the status of a request for a table.
inline proto::Status failure(proto::StatusCode code, std::string_view reason, std::string message) {
    return {code, std::move(message), std::string(reason), {}, 0};
}

}  // namespace contactd::engine
