// Reports progress of the computations of one call, and cancels them.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "call.hpp"
#include "contactd/observer.hpp"

namespace contactd::server {

using engine::JobProgress;
using engine::JobTable;

/// Encodes progress as on the wire, proto/schema/progress.json.
nlohmann::json to_json(const Job& job, const JobProgress& progress);

/// Forwards the progress of a build to a waiting call.
inline std::function<void(const Job&, const JobProgress&)> reports_to(const CallPtr& call) {
    return [call](const Job& job, const JobProgress& progress) { call->progress(to_json(job, progress)); };
}

/// Returns the origin of the job of a call; `kind` is "solve", ...
engine::JobOrigin origin_of(const Call& call, const std::string& kind);

/// Returns the job of a call, created on first use and listed from the time when the call begins to wait. Cancelling it
/// answers the call.
inline std::shared_ptr<Job> job_of(const CallPtr& call, const std::string& kind, JobTable& jobs) {
    if (call->job) return call->job;
    call->job = jobs.create(origin_of(*call, kind), [waiting = std::weak_ptr(call)] {
        if (const CallPtr known = waiting.lock()) known->fail(status_of(Cancelled("The job was cancelled.")));
    });
    // True if the request is abandoned, even if it is still referenced.
    call->when_answered([waiting = std::weak_ptr(call->job)] {
        if (const auto known = waiting.lock()) known->end();
    });
    return call->job;
}

inline JobProgress to_job_progress(const Progress& progress) {
    return {std::string(progress.stage), progress.fraction, progress.iteration, progress.residual,
            progress.seconds_left};
}

/// Forwards a job's progress to its caller. Short work needs none, so the first message is sent after this time, and
/// then one in each interval. Thread-safe.
class Reporter {
   public:
    Reporter(CallPtr call, std::shared_ptr<Job> job) : call_(std::move(call)), job_(std::move(job)) {}

    void report(const JobProgress& progress) {
        constexpr auto interval = std::chrono::milliseconds(200);
        {
            const std::scoped_lock lock(mutex_);
            if (Call::Clock::now() - last_ < interval) return;
            last_ = Call::Clock::now();
        }
        job_->set_progress(progress);
        call_->progress(to_json(*job_, progress));
    }

   private:
    const CallPtr call_;
    const std::shared_ptr<Job> job_;
    std::mutex mutex_;
    Call::Clock::time_point last_ = Call::Clock::now();
};

/// Ends a computation when its call has been answered or its deadline has passed.
class CallObserver : public Observer {
   public:
    explicit CallObserver(CallPtr call) : call_(std::move(call)) {}
    bool cancelled() const override {
        call_->check_deadline();
        return call_->answered();
    }
    std::string_view user() const override { return call_->user(); }

   private:
    const CallPtr call_;
};

/// Ends a computation when its job is cancelled, its call has been answered, or its deadline has passed.
class JobObserver final : public CallObserver {
   public:
    JobObserver(CallPtr call, std::shared_ptr<Job> job, std::function<void(const Progress&)> progress)
        : CallObserver(std::move(call)), job_(std::move(job)), progress_(std::move(progress)) {}
    void on_progress(const Progress& progress) override { progress_(progress); }
    bool cancelled() const override { return CallObserver::cancelled() || job_->cancelled(); }

   private:
    const std::shared_ptr<Job> job_;
    const std::function<void(const Progress&)> progress_;
};

}  // namespace contactd::server
