#include "session.hpp"

#include <utility>

#include "contactd/contact_influence.hpp"

namespace contactd::server {

using proto::StatusCode;
using proto::StatusError;

namespace {

// Beside the operators: gap, friction and tractions of the problem, as opened and as solved, and the state.
constexpr std::size_t bytes_per_element_problem = 300, bytes_per_element_state = 128, bytes_beside = 8192;
constexpr std::size_t bytes_per_element_table = 2 * 9 * sizeof(double);

StatusError state_unknown() {
    return {StatusCode::not_found, proto::reason::state_unknown,
            "The session has no such state; session.save names those there are, until session.forget."};
}

}  // namespace

std::size_t session_bytes(const ContactSetup& setup) {
    std::size_t per_element = bytes_per_element_problem + bytes_per_element_state;
    if (setup.bodies.any_given()) per_element += bytes_per_element_table;
    const std::size_t operators = setup.model == Model::full ? influence_bytes(setup.grid.size()) : 0;
    return bytes_beside + setup.grid.size() * per_element + operators;
}

StatusError session_unknown() {
    return {StatusCode::not_found, proto::reason::session_unknown,
            "There is no such session: it was closed, or never opened here."};
}

Session::Session(SessionSpec what, std::chrono::duration<double> lease_time, IcAnswers ics, ContactInfluence influence)
    : opened{std::move(what.setup), std::move(what.load)},
      accept_unconverged(what.accept_unconverged),
      lease(lease_time),
      ics_(std::move(ics)),
      problem_(opened),
      influence_(std::move(influence)),
      rolling_step_(step_of(opened)) {
    auto start = std::make_shared<SessionState>();
    start->tractions = opened.previous;
    state_ = std::move(start);
}

// --- turns -----------------------------------------------------------------------------------------------------------

void Session::take_turn(const Turn& turn, Work work, WorkerPool& workers) {
    {
        const std::scoped_lock lock(mutex_);
        last_used_ = Clock::now();
        // Never abandoned: what waits behind it in the session would be so, too.
        if (busy_) return waiting_.push_back({{turn.client, turn.priority, {}, turn.user}, std::move(work)});
        busy_ = true;
    }
    run_turns(work, workers);
}

// One at a time: in between the worker is free for others.
void Session::run_turns(const Work& work, WorkerPool& workers) {
    work(*this);
    Waiting next;
    {
        const std::scoped_lock lock(mutex_);
        last_used_ = Clock::now();
        if (waiting_.empty()) {
            busy_ = false;
            return;
        }
        next = std::move(waiting_.front());
        waiting_.pop_front();
    }
    workers.post(next.turn, [self = shared_from_this(), then = std::move(next.work), &workers] {
        self->run_turns(then, workers);
    });
}

// --- states ----------------------------------------------------------------------------------------------------------

SessionStatePtr Session::state() const {
    const std::scoped_lock lock(mutex_);
    return state_;
}

void Session::set_state(SessionStatePtr state) {
    const std::scoped_lock lock(mutex_);
    state_ = std::move(state);
}

std::string Session::save() {
    const std::scoped_lock lock(mutex_);
    const std::string name = "state-" + std::to_string(++serial_);
    states_.emplace(name, state_);
    return name;
}

SessionStatePtr Session::saved(const std::string& name) const {
    const std::scoped_lock lock(mutex_);
    const auto at = states_.find(name);
    if (at == states_.end()) throw state_unknown();
    return at->second;
}

std::size_t Session::forget(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    if (states_.erase(name) == 0) throw state_unknown();
    return states_.size();
}

std::size_t Session::states() const {
    const std::scoped_lock lock(mutex_);
    return states_.size();
}

// --- the lease -------------------------------------------------------------------------------------------------------

void Session::close() {
    std::shared_ptr<Job> job;
    {
        const std::scoped_lock lock(mutex_);
        closed_ = true;
        job = job_;
    }
    if (job) job->cancel();
}

bool Session::closed() const {
    const std::scoped_lock lock(mutex_);
    return closed_;
}

void Session::renew() {
    const std::scoped_lock lock(mutex_);
    last_used_ = Clock::now();
}

std::chrono::duration<double> Session::idle(Clock::time_point now) const {
    const std::scoped_lock lock(mutex_);
    if (busy_ || now < last_used_) return std::chrono::duration<double>::zero();
    return now - last_used_;
}

std::size_t Session::bytes() const {
    return session_bytes(opened) + states() * state_bytes();
}

std::size_t Session::state_bytes() const {
    return bytes_beside + opened.grid.size() * bytes_per_element_state;
}

}  // namespace contactd::server
