#include "session.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace contactd::server {

using proto::StatusCode;
using proto::StatusError;

namespace {

StatusError state_unknown() {
    return {StatusCode::not_found, proto::reason::state_unknown,
            "The session has no such state; use one that session.save returned and session.forget has not removed."};
}

}  // namespace

StatusError session_unknown() {
    return {StatusCode::not_found, proto::reason::session_unknown,
            "There is no such session: it was closed, or not opened here."};
}

Session::Session(std::unique_ptr<Simulation> simulation, std::chrono::duration<double> lease_time,
                 double seconds_of_a_step)
    : lease(lease_time),
      step_seconds(seconds_of_a_step),
      simulation_(std::move(simulation)),
      state_(std::make_shared<const SessionState>(
          SessionState{std::make_shared<const engine::StepState>(simulation_->start()), nullptr, {}})) {}

// --- order -----------------------------------------------------------------------------------------------------------

void Session::enqueue(QueueTicket ticket, Work work, WorkerPool& workers) {
    Waiting next{std::move(ticket), std::move(work)};
    {
        const std::scoped_lock lock(mutex_);
        last_used_ = Clock::now();
        if (busy_) return waiting_.push_back(std::move(next));
        busy_ = true;
    }
    post(std::move(next), workers);
}

bool Session::try_run(const Work& work, WorkerPool& workers) {
    {
        const std::scoped_lock lock(mutex_);
        if (busy_) return false;
        busy_ = true;
    }
    work();
    run_next(workers);
    return true;
}

// Runs one piece of work at a time, so that the worker is free for others in between.
void Session::post(Waiting next, WorkerPool& workers) {
    next.ticket.abandoned = {};  // Otherwise the work behind it in the session would be abandoned, too.
    workers.post(std::move(next.ticket), [self = shared_from_this(), work = std::move(next.work), &workers] {
        work();
        self->run_next(workers);
    });
}

void Session::run_next(WorkerPool& workers) {
    Waiting next;
    {
        const std::scoped_lock lock(mutex_);
        last_used_ = Clock::now();
        busy_ = !waiting_.empty();
        if (!busy_) return;
        next = std::move(waiting_.front());
        waiting_.pop_front();
    }
    post(std::move(next), workers);
}

void Session::drop_abandoned() {
    std::deque<Waiting> dropped;  // is destroyed after the lock is released, because it may hold much memory
    const std::scoped_lock lock(mutex_);
    const auto unwanted = std::stable_partition(waiting_.begin(), waiting_.end(), [](const Waiting& waiting) {
        return !waiting.ticket.abandoned || !waiting.ticket.abandoned();
    });
    std::move(unwanted, waiting_.end(), std::back_inserter(dropped));
    waiting_.erase(unwanted, waiting_.end());
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
    const std::scoped_lock lock(mutex_);
    std::size_t sum = simulation_->bytes();
    for (const auto& [name, state] : states_) sum += simulation_->state_bytes(*state->last);
    return sum;
}

std::size_t Session::state_bytes() const {
    return simulation_->state_bytes(*state()->last);
}

}  // namespace contactd::server
