// Serves calls without a socket: passes work to the methods and their threads.
#pragma once

#include <atomic>
#include <string>

#include "config/config.hpp"
#include "engine/engine.hpp"
#include "jobs/open_calls.hpp"
#include "methods/method_table.hpp"
#include "operation/counters.hpp"
#include "operation/health.hpp"
#include "operation/host.hpp"
#include "operation/metrics/metrics.hpp"
#include "sessions/session_table.hpp"

namespace contactd::server {

/// Owns the parts of the daemon, passes calls to their methods, and shuts down in order.
class Service {
   public:
    /// `config` must outlive it.
    Service(const Config& config, Host host);
    ~Service();

    const DaemonParts& parts() const { return parts_; }

    /// Returns the call of a request. Admits the request if it counts and has not been admitted (`admission` with the
    /// number 0). Returns null if it was answered while it was read. Throws StatusError as OpenCalls::admit.
    CallPtr open(const Route& route, proto::Request request, Call::Clock::time_point received,
                 OpenCalls::Admission admission, Call::Post post);
    /// Answers the call now or later. Called from the I/O thread, in which short methods run; all others run in
    /// workers. Never throws.
    void handle(CallPtr call);

    /// Refuses new requests with stop_status() from now on; accepted ones continue.
    void begin_drain();
    /// Calls begin_drain() and requests the end of running work. Does not wait.
    void begin_stop();
    /// Waits until all work has ended.
    void finish_stop();
    static const proto::Status& stop_status();

   private:
    void run(const Method* method, const CallPtr& call);
    void attempt(const CallPtr& call, const std::function<void()>& work);
    void begin(const Method& method, const CallPtr& call);
    bool is_at_once(const Method& method, const CallPtr& call);
    /// Returns the session of the call, or null.
    SessionPtr session_of(const CallPtr& call);

    const Host host_;
    OpenCalls open_calls_;  // outlives every call
    Counters counters_;
    const MethodTable methods_;
    RequestMetrics request_metrics_;
    Health health_;
    std::atomic<bool> stopping_ = false;
    engine::Engine engine_;
    SessionTable sessions_;
    RecentSolves recent_solves_;
    FileRuns file_runs_;
    WorkBudget budget_;
    const DaemonParts parts_;
    WorkerPool workers_;  // is destroyed first, because its threads use everything above
};

}  // namespace contactd::server
