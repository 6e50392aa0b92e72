// A session: the numbered steps of one simulation, of which each starts where the one before ended.
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

/// The state of a session: all that a step leaves to the next one. Never changed, so that saving a state is keeping it.
struct SessionState {
    std::shared_ptr<const engine::StepState> last;
    std::shared_ptr<const engine::StepState> before;  ///< where the last step started; null when there was none
    StepAnswer answer;
};
using SessionStatePtr = std::shared_ptr<const SessionState>;

class Session : public std::enable_shared_from_this<Session> {
   public:
    using Clock = std::chrono::steady_clock;

    /// `step_seconds`: of a processor, what a step will take about.
    Session(std::unique_ptr<Simulation> simulation, std::chrono::duration<double> lease, double step_seconds = 0);

    /// The simulation that is stepped through; const, because work in the order of the session alone takes steps.
    const Simulation& simulation() const { return *simulation_; }
    const std::chrono::duration<double> lease;
    const double step_seconds;
    const Clock::time_point created = Clock::now();

    // Requests of one session run one after another, in the order in which they come here; sessions run side by side.
    using Work = WorkerPool::Task;
    /// Runs `work` on a worker, after what came before. Renews the lease.
    void enqueue(QueueTicket ticket, Work work, WorkerPool& workers);
    /// Runs `work` here and now when nothing runs or waits in the session; false when something does.
    bool try_run(const Work& work, WorkerPool& workers);
    /// Drops work that waits and was abandoned.
    void drop_abandoned();

    /// Within enqueue or try_run: sends the answer to a step, solved now or cached. The session goes on only when it
    /// was sent: whatever fails leaves it as it was. Throws what failed.
    void step(const StepRequest& request, engine::Engine& engine);

    SessionStatePtr state() const;
    long long step_number() const { return state()->last->step; }  ///< of the last step
    std::size_t elements() const { return simulation_->elements(*state()->last); }
    /// Within enqueue or try_run.
    void set_state(SessionStatePtr state);

    /// Keeps the state; the name is new in this session.
    std::string save();
    /// Throws StatusError when there is no such state.
    SessionStatePtr saved(const std::string& name) const;
    /// How many are left. Throws StatusError when there is no such state.
    std::size_t forget(const std::string& name);
    std::size_t states() const;

    /// From now on work finds the session closed; a running step is cancelled.
    void close();
    bool closed() const;

    void renew();
    /// How long nobody has used it; zero while somebody does.
    std::chrono::duration<double> idle(Clock::time_point now) const;

    std::size_t bytes() const;        ///< what it takes in memory, about, with its states
    std::size_t state_bytes() const;  ///< of the state where it is

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
    mutable std::mutex mutex_;  // guards what follows
    SessionStatePtr state_;
    std::map<std::string, SessionStatePtr> states_;
    long long serial_ = 0;
    std::shared_ptr<Job> job_;
    std::deque<Waiting> waiting_;
    bool busy_ = false;
    bool closed_ = false;
    Clock::time_point last_used_ = Clock::now();
};

/// NOT_FOUND: the session has ended, or never was.
proto::StatusError session_unknown();

}  // namespace contactd::server
