// Work that takes its time, builds, solves and stresses: what job.list shows and job.cancel ends.
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
    std::optional<double> seconds_left = std::nullopt;  ///< an estimate, where there is one
    std::optional<std::uint64_t> memory_bytes =
        std::nullopt;  ///< the most it will take, an estimate, where there is one
};

/// Kind and owner of a job.
struct JobOrigin {
    std::string kind;         ///< "build", "solve", "subsurface", "temperature" or "step"
    std::string description;  ///< words for people: what is built or solved
    /// Users of the requests that wait for the job at present, one for each request; "" where there are no users.
    std::function<std::vector<std::string>()> users;
};

/// `on_cancel` is called once, from whatever thread cancels, so that those who wait are answered at once.
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
    /// Said before the callers are answered, so that none of them finds the job listed afterwards.
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

/// The jobs that are queued or running. Thread-safe; a job is listed until it ends or nobody holds it any more.
class JobTable {
   public:
    /// Takes the arguments of the constructor of Job; the name is the kind and a number.
    std::shared_ptr<Job> create(JobOrigin origin, std::function<void()> on_cancel) {
        const std::scoped_lock lock(mutex_);
        forget_ended();
        std::string name = origin.kind + "-" + std::to_string(++serial_);
        auto job = std::make_shared<Job>(std::move(name), std::move(origin), std::move(on_cancel));
        jobs_.emplace(serial_, job);
        return job;
    }
    /// In order of creation.
    std::vector<std::shared_ptr<Job>> all() const {
        const std::scoped_lock lock(mutex_);
        std::vector<std::shared_ptr<Job>> jobs;
        for (const auto& [serial, weak] : jobs_)
            if (auto job = weak.lock(); job && !job->ended()) jobs.push_back(std::move(job));
        return jobs;
    }
    /// Null when no job has that name.
    std::shared_ptr<Job> find(const std::string& name) const {
        for (auto& job : all())
            if (job->name == name) return job;
        return nullptr;
    }

   private:
    /// Now and then, so that jobs cost the same however many there are.
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
