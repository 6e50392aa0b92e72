// What contacts and wheels have in common: one user at a time, a log, the last failure, and calls that another thread
// can end.
#pragma once

#include <atomic>
#include <mutex>
#include <stop_token>

#include "connection.hpp"
#include "turn.hpp"

namespace contactd::c {

class Called {
   public:
    std::atomic<int> user;  ///< of Turn

    /// From any thread: ends what runs, and what has its turn but does not run yet.
    void cancel() {
        Turn::cancel(user);
        const std::scoped_lock lock(mutex_);
        stop_.request_stop();
    }

    const Log& log() const { return log_; }
    void keep(const Failure& failure) {
        const std::scoped_lock lock(mutex_);
        last_ = failure;
    }
    Failure last_failure() const {
        const std::scoped_lock lock(mutex_);
        return last_;
    }

   protected:
    explicit Called(const Connection& connection)
        : user(0), backend_(connection.backend), settings_(connection.told().first), log_(connection.told().second) {}
    ~Called() = default;

    /// Calls `ask` with a Control that cancel() reaches.
    template <class Ask>
    auto controlled(const Ask& ask) {
        Control control;
        {
            const std::scoped_lock lock(mutex_);
            stop_ = std::stop_source();
            if (Turn::is_cancelled(user)) stop_.request_stop();
            control.stop = stop_.get_token();
        }
        struct Ended {
            Called& called;
            ~Ended() {
                const std::scoped_lock lock(called.mutex_);
                called.stop_ = std::stop_source(std::nostopstate);
            }
        } const ended{*this};
        return ask(control);
    }

    const std::shared_ptr<const Backend> backend_;
    const Settings settings_;
    const Log log_;

   private:
    mutable std::mutex mutex_;  // guards what follows
    std::stop_source stop_{std::nostopstate};
    Failure last_;
};

}  // namespace contactd::c
