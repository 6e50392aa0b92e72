// The methods of the wire: what each request does, with what the rest of the daemon offers.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "config/config.hpp"
#include "ics/ic_service.hpp"
#include "ics/influence_cache.hpp"
#include "jobs/call.hpp"
#include "jobs/job.hpp"
#include "jobs/worker_pool.hpp"
#include "operation/counters.hpp"
#include "operation/health.hpp"
#include "operation/metrics.hpp"
#include "sessions/session_table.hpp"
#include "wire/open_calls.hpp"

namespace contactd::server {

class Service {
   public:
    explicit Service(const Config& config);

    /// Answers the call now or later. Called from the I/O thread, which quick methods may keep for a moment; all others
    /// go to the workers. Never throws.
    void handle(CallPtr call);

    /// Whether requests to the method may take their time, and count against the limits on those that do.
    bool counts(const std::string& method) const;
    /// Lets go of work that waits for calls which have been answered.
    void drop_abandoned();

    /// From now on requests are refused with stop_status(); what was accepted goes on.
    void begin_drain();
    /// As begin_drain(), and running work is told to end. Does not wait.
    void begin_stop();
    /// Waits until all work has ended.
    void finish_stop();
    static const proto::Status& stop_status();

    /// Of requests to the method that name none.
    proto::Priority priority_of(const std::string& method) const;

    /// The open sessions, whose leases the I/O thread watches.
    SessionTable& sessions() { return sessions_; }

    Counters& counters() { return counters_; }
    RequestMetrics& request_metrics() { return request_metrics_; }

    /// All that is measured. From any thread; `look_at_store` counts the files of the store, which takes its time when
    /// there are many.
    MetricFamilies metrics(bool look_at_store);

    /// Why requests should not be sent here at present, a sentence; empty when all is well. From any thread.
    std::string not_ready() const;
    void set_serving() { serving_ = true; }
    OpenCalls& open_calls() { return open_calls_; }

   private:
    using Method = void (Service::*)(const CallPtr&);
    struct Entry {
        Method method;
        bool is_quick;            ///< runs in the I/O thread
        bool counts = !is_quick;  ///< among the requests that wait for an answer
        proto::Priority priority = proto::Priority::normal;
        const char* job = nullptr;  ///< what job.list calls it, where it is listed
    };

    bool is_quick(const std::string& method) const;
    SolveTools solve_tools() { return {ics_, workers_, influences_, jobs_, counters_}; }
    void run(Method method, const CallPtr& call);
    void server_info(const CallPtr& call);
    void server_health(const CallPtr& call);
    void server_describe(const CallPtr& call);
    void server_metrics(const CallPtr& call);
    void health_watch(const CallPtr& call);
    void ic_get(const CallPtr& call);
    void ic_export(const CallPtr& call);
    void ic_list(const CallPtr& call);
    void ic_delete(const CallPtr& call);
    void contact_solve(const CallPtr& call);
    void contact_solve_many(const CallPtr& call);
    void contact_subsurface(const CallPtr& call);
    void session_open(const CallPtr& call);
    void session_step(const CallPtr& call);
    void session_info(const CallPtr& call);
    void session_save(const CallPtr& call);
    void session_restore(const CallPtr& call);
    void session_forget(const CallPtr& call);
    void session_close(const CallPtr& call);
    void session_list(const CallPtr& call);
    void job_list(const CallPtr& call);
    void job_cancel(const CallPtr& call);
    void request_cancel(const CallPtr& call);

    const Config& config_;
    const Call::Clock::time_point started_ = Call::Clock::now();
    OpenCalls open_calls_;  // outlives every call
    Counters counters_;
    JobTable jobs_;
    std::map<std::string, Entry> methods_;
    RequestMetrics request_metrics_;
    std::atomic<bool> serving_ = false;
    Health health_;
    std::atomic<bool> stopping_ = false;
    IcService ics_;
    InfluenceCache influences_;
    SessionTable sessions_;
    WorkerPool workers_;  // last: its threads use everything above
};

}  // namespace contactd::server
