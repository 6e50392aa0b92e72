// Represents a session: the numbered steps of one simulation, each of which starts from the end of the previous one.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "simulation.hpp"

namespace contactd::server {

/// Holds the state of a session: all data that a step passes to the next one. It is immutable, so keeping a state saves
/// it.
struct SessionState {
    std::shared_ptr<const engine::StepState> last;
    std::shared_ptr<const engine::StepState> before;  ///< start of the last step; null before the first one
    StepAnswer answer;
};
using SessionStatePtr = std::shared_ptr<const SessionState>;

class Session : public std::enable_shared_from_this<Session> {
   public:
    using Clock = std::chrono::steady_clock;

    /// `step_seconds`: approximate processor time of a step.
    Session(std::unique_ptr<Simulation> simulation, std::chrono::duration<double> lease, double step_seconds = 0);

    /// Returns the simulation; const, because only work in the order of the session takes steps.
    const Simulation& simulation() const { return *simulation_; }
    const std::chrono::duration<double> lease;
    const double step_seconds;
    const Clock::time_point created = Clock::now();

    // Requests of one session run one after another, in the order of arrival; sessions run in parallel.
    using Work = WorkerPool::Task;
    /// Runs `work` on a worker, after earlier work of the session. Renews the lease.
    void enqueue(QueueTicket ticket, Work work, WorkerPool& workers);
    /// Runs `work` immediately in this thread if the session is idle; otherwise returns false.
    bool try_run(const Work& work, WorkerPool& workers);
    /// Drops abandoned waiting work.
    void drop_abandoned();

    /// Sends the answer to a step, solved now or cached; call it within enqueue or try_run. The session advances only
    /// if the answer was sent; any failure leaves it unchanged. Throws the failure.
    void step(const StepRequest& request, engine::Engine& engine);

    SessionStatePtr state() const;
    long long step_number() const { return state()->last->step; }  ///< of the last step
    std::size_t elements() const { return simulation_->elements(*state()->last); }
    /// Must be called within enqueue or try_run.
    void set_state(SessionStatePtr state);

    /// Stores the state under a new name.
    std::string save();
    /// Throws StatusError if the state does not exist.
    SessionStatePtr saved(const std::string& name) const;
    /// Returns the number of remaining states. Throws StatusError if the state does not exist.
    std::size_t forget(const std::string& name);
    std::size_t states() const;

    /// Closes the session for further work, and cancels a running step.
    void close();
    bool closed() const;

    void renew();
    /// Returns the time since its last use; zero while it is in use.
    std::chrono::duration<double> idle(Clock::time_point now) const;

    std::size_t bytes() const;        ///< approximate memory, including its states
    std::size_t state_bytes() const;  ///< approximate memory of the current state

   private:
    struct Waiting {
        QueueTicket ticket;
        Work work;
    };
    void post(Waiting next, WorkerPool& workers);
    void run_next(WorkerPool& workers);
    void begin(const std::shared_ptr<Job>& job);
    void solve_step(const std::shared_ptr<const engine::StepState>& before, std::size_t hash,
                    const StepRequest& request, engine::Engine& engine);

    const std::unique_ptr<Simulation> simulation_;
    mutable std::mutex mutex_;  // guards the members below
    SessionStatePtr state_;
    std::map<std::string, SessionStatePtr> states_;
    long long serial_ = 0;
    std::shared_ptr<Job> job_;
    std::deque<Waiting> waiting_;
    bool busy_ = false;
    bool closed_ = false;
    Clock::time_point last_used_ = Clock::now();
};

/// NOT_FOUND: the session has ended or never existed.
proto::StatusError session_unknown();

}  // namespace contactd::server
