// Lists and cancels long-running work (job.list, job.cancel): builds, solves and stresses.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace contactd::engine {

struct JobProgress {
    std::string stage = "queued";
    double fraction = 0;
    int iteration = 0;
    double residual = 0;
    std::optional<double> seconds_left = std::nullopt;         ///< estimate, if available
    std::optional<std::uint64_t> memory_bytes = std::nullopt;  ///< estimate of the largest memory, if available
};

/// Holds the kind and owner of a job.
struct JobOrigin {
    std::string kind;         ///< "build", "solve", "subsurface", "temperature" or "step"
    std::string description;  ///< describes the build or solve for readers
    /// Returns the users of the requests that currently wait for the job, one for each request; "" without users.
    std::function<std::vector<std::string>()> users;
};

/// `on_cancel` is called once, from the cancelling thread, so that waiting requests are answered immediately.
class Job {
   public:
    Job(std::string job_name, JobOrigin origin, std::function<void()> on_cancel)
        : name(std::move(job_name)),
          kind(std::move(origin.kind)),
          description(std::move(origin.description)),
          users_(std::move(origin.users)),
          on_cancel_(std::move(on_cancel)) {}

    const std::string name;  ///< "build-3"
    const std::string kind;  ///< as JobOrigin::kind
    const std::string description;
    const std::chrono::steady_clock::time_point created = std::chrono::steady_clock::now();

    void cancel() {
        if (!cancelled_.exchange(true)) on_cancel_();
    }
    bool cancelled() const { return cancelled_; }
    /// Must be called before the callers are answered, so that none of them finds the job listed afterwards.
    void end() { ended_ = true; }
    bool ended() const { return ended_; }
    void set_running() { running_ = true; }
    bool running() const { return running_; }
    std::vector<std::string> users() const { return users_(); }
    int callers() const { return static_cast<int>(users_().size()); }

    void set_progress(JobProgress progress) {
        const std::scoped_lock lock(mutex_);
        progress_ = std::move(progress);
    }
    JobProgress progress() const {
        const std::scoped_lock lock(mutex_);
        return progress_;
    }

   private:
    const std::function<std::vector<std::string>()> users_;
    const std::function<void()> on_cancel_;
    std::atomic<bool> cancelled_ = false;
    std::atomic<bool> running_ = false;
    std::atomic<bool> ended_ = false;
    mutable std::mutex mutex_;
    JobProgress progress_;
};

/// Holds the queued and running jobs. Thread-safe. A job is listed until it ends or is no longer referenced.
class JobTable {
   public:
    /// Creates a job from the arguments of its constructor; the name is the kind and a number.
    std::shared_ptr<Job> create(JobOrigin origin, std::function<void()> on_cancel) {
        const std::scoped_lock lock(mutex_);
        forget_ended();
        std::string name = origin.kind + "-" + std::to_string(++serial_);
        auto job = std::make_shared<Job>(std::move(name), std::move(origin), std::move(on_cancel));
        jobs_.emplace(serial_, job);
        return job;
    }
    /// Returns the jobs in order of creation.
    std::vector<std::shared_ptr<Job>> all() const {
        const std::scoped_lock lock(mutex_);
        std::vector<std::shared_ptr<Job>> jobs;
        for (const auto& [serial, weak] : jobs_)
            if (auto job = weak.lock(); job && !job->ended()) jobs.push_back(std::move(job));
        return jobs;
    }
    /// Returns the job with this name, or null.
    std::shared_ptr<Job> find(const std::string& name) const {
        for (auto& job : all())
            if (job->name == name) return job;
        return nullptr;
    }

   private:
    /// Removes ended jobs from time to time, so that the cost of a job does not depend on their number.
    void forget_ended() {
        if (jobs_.size() < enough_) return;
        std::erase_if(jobs_, [](const auto& entry) { return entry.second.expired(); });
        enough_ = 2 * jobs_.size() + 16;
    }

    mutable std::mutex mutex_;
    long long serial_ = 0;
    std::size_t enough_ = 16;
    std::map<long long, std::weak_ptr<Job>> jobs_;
};

}  // namespace contactd::engine
