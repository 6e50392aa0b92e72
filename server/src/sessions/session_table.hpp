// The open sessions: their names, leases and limits.
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

/// Thread-safe. Sessions end when nobody has used them for their lease.
class SessionTable {
   public:
    using Clock = Session::Clock;

    explicit SessionTable(const SessionLimits& limits) : limits_(limits) {}

    /// The lease that a request gets. Throws StatusError when it asks for more than there is.
    std::chrono::duration<double> lease(const std::optional<double>& seconds) const;

    /// Throws StatusError (SESSION_LIMIT) when a session of that size would be too many.
    void check_room(std::size_t bytes) const;
    /// The name of the session: 128 random bits in hexadecimal. Throws as check_room.
    std::string add(SessionPtr session);
    /// Renews the lease; null when there is no such session.
    SessionPtr find_open(const std::string& name);
    /// Renews the lease. Throws StatusError (SESSION_UNKNOWN, SESSION_EXPIRED).
    SessionPtr find(const std::string& name);
    /// Closes the session. Throws as find.
    SessionPtr remove(const std::string& name);
    /// Keeps the state of a session under a new name. Throws StatusError (SESSION_LIMIT).
    std::string save(Session& session);

    /// Ends the sessions whose lease is over; costs next to nothing before next_expiry().
    void expire(Clock::time_point now);
    /// When `expire` should be called, at the latest; never when there are no sessions.
    Clock::time_point next_expiry() const;

    /// Drops what waits in sessions and was abandoned.
    void drop_abandoned() const;

    /// In order of opening.
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
    std::deque<std::string> expired_;  // the last ones, so that their users learn what happened
    Clock::time_point next_expiry_ = Clock::time_point::max();
};

}  // namespace contactd::server
