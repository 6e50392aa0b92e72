// Provides the common base of contacts and wheels: one user at a time, a log, the last failure, and calls that can be
// cancelled.
#pragma once

#include <atomic>
#include <cstdio>
#include <mutex>
#include <set>
#include <stop_token>
#include <string>

#include "connection.hpp"
#include "handle_guard.hpp"
#include "paths.hpp"

namespace contactd::c {

class CancellableHandle {
   public:
    std::atomic<int> user;  ///< for HandleGuard
    PathCache paths;        ///< for the current user

    /// Cancels the running call, or one that is about to run, from any thread.
    void cancel() {
        HandleGuard::cancel(user);
        const std::scoped_lock lock(mutex_);
        stop_.request_stop();
    }

    const Log& log() const { return log_; }
    /// Reports to the log; without one to standard error, each sentence once.
    void warn(const std::string& sentence) {
        constexpr std::size_t most = 1000;
        if (log_.is_set) return log_(CONTACTD_LOG_WARNING, sentence);
        if (warned_.size() < most && warned_.insert(sentence).second)
            std::fprintf(stderr, "contactd: warning: %s\n", sentence.c_str());
    }
    void keep(const Failure& failure) {
        const std::scoped_lock lock(mutex_);
        last_ = failure;
    }
    Failure last_failure() const {
        const std::scoped_lock lock(mutex_);
        return last_;
    }

   protected:
    CancellableHandle(const Connection& connection, Roots inputs, Roots results)
        : user(0),
          paths(inputs, results),
          backend_(connection.backend),
          settings_(connection.snapshot().first),
          log_(connection.snapshot().second) {}
    ~CancellableHandle() = default;

    /// Provides a Control that cancel() can stop during the lifetime of this object.
    class Controlled {
       public:
        explicit Controlled(CancellableHandle& called) : called_(called) {
            const std::scoped_lock lock(called.mutex_);
            called.stop_ = std::stop_source();
            if (HandleGuard::is_cancelled(called.user)) called.stop_.request_stop();
            control.stop = called.stop_.get_token();
        }
        ~Controlled() {
            const std::scoped_lock lock(called_.mutex_);
            called_.stop_ = std::stop_source(std::nostopstate);
        }
        Controlled(const Controlled&) = delete;
        Controlled& operator=(const Controlled&) = delete;

        Control control;

       private:
        CancellableHandle& called_;
    };
    template <class Ask>
    auto controlled(const Ask& ask) {
        Controlled call(*this);
        return ask(call.control);
    }

    const std::shared_ptr<const Backend> backend_;
    const Settings settings_;
    const Log log_;

   private:
    std::set<std::string> warned_;
    mutable std::mutex mutex_;  // guards the members below
    std::stop_source stop_{std::nostopstate};
    Failure last_;
};

}  // namespace contactd::c
