// Manages the open sessions: their names, leases and limits.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "config/config.hpp"
#include "session.hpp"

namespace contactd::server {

using SessionPtr = std::shared_ptr<Session>;

/// Thread-safe. Sessions end when they have not been used for their lease.
class SessionTable {
   public:
    using Clock = Session::Clock;

    explicit SessionTable(const SessionLimits& limits) : limits_(limits) {}

    /// Returns the lease for a request. Throws StatusError if it requests more than allowed.
    std::chrono::duration<double> lease(const std::optional<double>& seconds) const;

    /// Throws StatusError (SESSION_LIMIT) if a session of that size would exceed the limits.
    void check_room(std::size_t bytes) const;
    /// Adds a session and returns its name: 128 random bits in hexadecimal. Throws as check_room.
    std::string add(SessionPtr session);
    /// Returns the session after renewing its lease, or null.
    SessionPtr find_open(const std::string& name);
    /// Returns the session after renewing its lease. Throws StatusError (SESSION_UNKNOWN, SESSION_EXPIRED).
    SessionPtr find(const std::string& name);
    /// Closes the session. Throws as find.
    SessionPtr remove(const std::string& name);
    /// Stores the state of a session under a new name. Throws StatusError (SESSION_LIMIT).
    std::string save(Session& session);

    /// Ends the sessions whose lease has expired; almost free before next_expiry().
    void expire(Clock::time_point now);
    /// Returns the latest time for a call of `expire`; never if there are no sessions.
    Clock::time_point next_expiry() const;

    /// Drops abandoned waiting work of sessions.
    void drop_abandoned() const;

    /// Returns the sessions in order of opening.
    std::vector<SessionPtr> all() const;
    std::size_t bytes() const;

   private:
    std::size_t sum_of_bytes() const;
    void check_bytes(std::size_t more) const;
    void bury(const std::string& name);
    proto::StatusError absent(const std::string& name) const;

    const SessionLimits& limits_;
    mutable std::mutex mutex_;
    std::map<std::string, SessionPtr, std::less<>> sessions_;
    std::deque<std::string> expired_;  // keeps the last ones, so that their users learn the reason
    Clock::time_point next_expiry_ = Clock::time_point::max();
};

}  // namespace contactd::server
