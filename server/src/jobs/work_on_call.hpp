// Connects a call and its job in a worker.
#pragma once

#include <memory>
#include <string_view>
#include <utility>

#include "job_reports.hpp"

namespace contactd::server {

/// Forwards the progress of a computation to its call, and its cancellation to the computation.
class WorkOnCall {
   public:
    WorkOnCall(const CallPtr& call, JobTable& jobs)
        : call_(call),
          job_(job_of(call, "solve", jobs)),
          reporter_(call, job_),
          observer_(call, job_, [this](const Progress& progress) { reporter_.report(to_job_progress(progress)); }) {
        job_->set_running();
    }

    Observer& observer() { return observer_; }
    void succeed(const nlohmann::json& result, proto::Frames frames = {}) {
        job_->end();
        call_->succeed(result, std::move(frames));
    }
    /// Answers with the JSON text of a result.
    void succeed_with(std::string_view result, proto::Frames frames) {
        job_->end();
        call_->succeed_with(result, std::move(frames));
    }

   private:
    const CallPtr call_;
    const std::shared_ptr<Job> job_;
    Reporter reporter_;
    JobObserver observer_;
};

}  // namespace contactd::server
