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

#include "contactd/proto/session.hpp"
#include "engine/engine.hpp"
#include "jobs/job_reports.hpp"

namespace contactd::server {

/// The answer to a step, kept to be sent again.
struct StepAnswer {
    std::size_t request = 0;  ///< hash of what was asked
    nlohmann::json result;
    std::vector<std::string> frames;
};

/// Where a session is: all that a step leaves to the next one. Never changed, so that saving a state is holding it.
struct SessionState {
    std::shared_ptr<const engine::StepState> contact;
    std::shared_ptr<const engine::StepState> before;  ///< where the last step started; null when there was none
    StepAnswer answer;
};
using SessionStatePtr = std::shared_ptr<const SessionState>;

/// A step that a request asks for.
struct StepRequest {
    const nlohmann::json& params;  ///< of session.step, which have passed their schema
    const CallPtr& call;           ///< has the frames that they refer to
    const std::shared_ptr<Job>& job;
    std::function<void(const JobProgress&)> report;
    std::function<void()> check_rest;             ///< of the request, once the step's own fields have been read
    std::function<bool(const StepAnswer&)> send;  ///< false when nobody wants the answer any more
};

class Session : public std::enable_shared_from_this<Session> {
   public:
    using Clock = std::chrono::steady_clock;

    Session(std::unique_ptr<engine::ContactSteps> steps, std::chrono::duration<double> lease);

    /// What all steps have in common, and what holds for those that do not say it.
    const ContactProblem& opened() const { return steps_->opened; }
    const std::chrono::duration<double> lease;
    const Clock::time_point created = Clock::now();

    // Requests of one session run one after another, in the order in which they come here; sessions run side by side.
    using Work = WorkerPool::Task;
    /// Runs `work` on a worker, after what came before. Renews the lease.
    void take_turn(Turn turn, Work work, WorkerPool& workers);
    /// Runs `work` here and now when nothing runs or waits in the session; false when something does.
    bool try_turn(const Work& work, WorkerPool& workers);
    /// Drops what waits for its turn and was abandoned.
    void drop_abandoned();

    /// In a turn: sends the answer to a step, solved now or kept. The session goes on only when the answer was sent:
    /// whatever fails leaves it as it was. Throws what failed.
    void step(const StepRequest& request, engine::Engine& engine);

    const engine::IcAnswers& ics() const { return steps_->ics(); }
    SessionStatePtr state() const;
    /// In a turn.
    void set_state(SessionStatePtr state);

    /// Keeps the state; the name is new in this session.
    std::string save();
    /// Throws StatusError when there is no such state.
    SessionStatePtr saved(const std::string& name) const;
    /// How many are left. Throws StatusError when there is no such state.
    std::size_t forget(const std::string& name);
    std::size_t states() const;

    /// From now on turns find the session closed; a running step is cancelled.
    void close();
    bool closed() const;

    void renew();
    /// How long nobody has used it; zero while somebody does.
    std::chrono::duration<double> idle(Clock::time_point now) const;

    std::size_t bytes() const;        ///< what it takes in memory, about, with its states
    std::size_t state_bytes() const;  ///< of each state

   private:
    struct Waiting {
        Turn turn;
        Work work;
    };
    void post_turn(Waiting next, WorkerPool& workers);
    void end_turn(WorkerPool& workers);
    void begin(const std::shared_ptr<Job>& job);
    void solve_step(const std::shared_ptr<const engine::StepState>& before, std::size_t hash,
                    const StepRequest& request, engine::Engine& engine);

    const std::unique_ptr<engine::ContactSteps> steps_;  // used in turns only
    mutable std::mutex mutex_;                           // guards what follows
    SessionStatePtr state_;
    std::map<std::string, SessionStatePtr> states_;
    long long serial_ = 0;
    std::shared_ptr<Job> job_;
    std::deque<Waiting> waiting_;
    bool busy_ = false;
    bool closed_ = false;
    Clock::time_point last_used_ = Clock::now();
};

/// What a session of `setup` will take in memory, about.
std::size_t session_bytes(const ContactSetup& setup);

/// NOT_FOUND: the session has ended, or never was.
proto::StatusError session_unknown();

}  // namespace contactd::server
