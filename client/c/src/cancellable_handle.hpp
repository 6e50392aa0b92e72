// Contacts and wheels have one user at a time, a log, the last failure, and calls that another thread can cancel.
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
    std::atomic<int> user;  ///< of HandleGuard
    PathCache paths;        ///< of who has its turn

    /// From any thread: ends what runs, and what has its turn but does not run yet.
    void cancel() {
        HandleGuard::cancel(user);
        const std::scoped_lock lock(mutex_);
        stop_.request_stop();
    }

    const Log& log() const { return log_; }
    /// Tells the log; where none was set, standard error, and each sentence once.
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

    /// A Control that cancel() reaches while this lives.
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
    mutable std::mutex mutex_;  // guards what follows
    std::stop_source stop_{std::nostopstate};
    Failure last_;
};

}  // namespace contactd::c
