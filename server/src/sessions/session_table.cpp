#include "session_table.hpp"

#include <algorithm>
#include <utility>

#include "sessions/random_name.hpp"

namespace contactd::server {

using proto::StatusCode;
using proto::StatusError;

namespace {

constexpr std::size_t remembered_expired = 1024;

StatusError limit(const std::string& sentence) {
    return {StatusCode::resource_exhausted, proto::reason::session_limit, sentence};
}

}  // namespace

std::chrono::duration<double> SessionTable::lease(const std::optional<double>& seconds) const {
    const double lease = seconds.value_or(std::min(limits_.lease_seconds, limits_.max_lease_seconds));
    if (lease > limits_.max_lease_seconds)
        throw proto::invalid_field("lease_seconds",
                                   "is " + proto::dump(lease) + ", but at most " +
                                       proto::dump(limits_.max_lease_seconds) +
                                       " are allowed (limits.max_lease_seconds)",
                                   proto::reason::limit_exceeded);
    return std::chrono::duration<double>(lease);
}

std::size_t SessionTable::sum_of_bytes() const {
    std::size_t sum = 0;
    for (const auto& [name, session] : sessions_) sum += session->bytes();
    return sum;
}

void SessionTable::check_bytes(std::size_t more) const {
    const std::size_t bytes = sum_of_bytes();
    if (bytes + more > limits_.max_bytes)
        throw limit("Sessions and their states use " + std::to_string(bytes) + " bytes, and this request needs " +
                    std::to_string(more) + " more, but at most " + std::to_string(limits_.max_bytes) +
                    " are allowed together (limits.max_session_bytes). Close sessions or forget states.");
}

void SessionTable::check_room(std::size_t bytes) const {
    const std::scoped_lock lock(mutex_);
    if (sessions_.size() >= limits_.max_sessions)
        throw limit(
            "There are " + std::to_string(sessions_.size()) +
            " sessions, the largest number allowed (limits.max_sessions); close one, or wait until a lease ends.");
    check_bytes(bytes);
}

std::string SessionTable::add(SessionPtr session) {
    check_room(session->bytes());
    std::string name = random_name();
    const std::scoped_lock lock(mutex_);
    const auto expiry = Clock::now() + std::chrono::duration_cast<Clock::duration>(session->lease);
    next_expiry_ = std::min(next_expiry_, expiry);
    sessions_.emplace(name, std::move(session));
    return name;
}

StatusError SessionTable::absent(const std::string& name) const {
    if (std::find(expired_.begin(), expired_.end(), name) == expired_.end()) return session_unknown();
    return {StatusCode::not_found, proto::reason::session_expired,
            "The session has ended because no request used it within its lease. Open another one."};
}

SessionPtr SessionTable::find_open(const std::string& name) {
    expire(Clock::now());
    const std::scoped_lock lock(mutex_);
    const auto at = sessions_.find(name);
    if (at == sessions_.end()) return nullptr;
    at->second->renew();
    return at->second;
}

SessionPtr SessionTable::find(const std::string& name) {
    SessionPtr session = find_open(name);
    if (session) return session;
    const std::scoped_lock lock(mutex_);
    throw absent(name);
}

SessionPtr SessionTable::remove(const std::string& name) {
    SessionPtr session = find(name);
    {
        const std::scoped_lock lock(mutex_);
        if (sessions_.erase(name) == 0) throw session_unknown();
    }
    session->close();
    return session;
}

std::string SessionTable::save(Session& session) {
    const std::scoped_lock lock(mutex_);
    if (session.states() >= limits_.max_states)
        throw limit(
            "The session has " + std::to_string(session.states()) +
            " saved states, the largest number allowed (limits.max_session_states); remove one with session.forget.");
    check_bytes(session.state_bytes());
    return session.save();
}

void SessionTable::bury(const std::string& name) {
    expired_.push_back(name);
    if (expired_.size() > remembered_expired) expired_.pop_front();
}

void SessionTable::expire(Clock::time_point now) {
    std::vector<SessionPtr> ended;  // Is closed and freed without the lock.
    {
        const std::scoped_lock lock(mutex_);
        if (now < next_expiry_) return;
        next_expiry_ = Clock::time_point::max();
        for (auto at = sessions_.begin(); at != sessions_.end();) {
            const std::chrono::duration<double> left = at->second->lease - at->second->idle(now);
            if (left.count() <= 0) {
                bury(at->first);
                ended.push_back(std::move(at->second));
                at = sessions_.erase(at);
                continue;
            }
            // If its lease was renewed meanwhile, the session is checked again later.
            next_expiry_ = std::min(next_expiry_, now + std::chrono::ceil<std::chrono::milliseconds>(left));
            ++at;
        }
    }
    for (const SessionPtr& session : ended) session->close();
}

SessionTable::Clock::time_point SessionTable::next_expiry() const {
    const std::scoped_lock lock(mutex_);
    return next_expiry_;
}

void SessionTable::drop_abandoned() const {
    for (const SessionPtr& session : all()) session->drop_abandoned();
}

std::vector<SessionPtr> SessionTable::all() const {
    std::vector<SessionPtr> sessions;
    {
        const std::scoped_lock lock(mutex_);
        for (const auto& [name, session] : sessions_) sessions.push_back(session);
    }
    std::sort(sessions.begin(), sessions.end(),
              [](const SessionPtr& a, const SessionPtr& b) { return a->created < b->created; });
    return sessions;
}

std::size_t SessionTable::bytes() const {
    const std::scoped_lock lock(mutex_);
    return sum_of_bytes();
}

}  // namespace contactd::server
