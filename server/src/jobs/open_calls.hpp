// Counts and limits the requests that wait for an answer.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "call.hpp"

namespace contactd::server {

/// Thread-safe. A request is admitted, gets its call once it has been read, and is closed when its answer is sent.
class OpenCalls {
   public:
    using Number = CallNumber;
    struct Bounds {
        std::size_t calls;
        std::size_t calls_per_client;
        std::size_t bytes;               ///< limit of their messages; a single request is always accepted
        std::size_t calls_per_user = 0;  ///< for one user over all connections; 0: no limit
    };
    /// Released with the last copy.
    using ReservedBytes = std::shared_ptr<const void>;
    struct Admission {
        Number number = 0;
        ReservedBytes bytes;
    };

    explicit OpenCalls(const Bounds& bounds) : bounds_(bounds) {}

    /// Throws StatusError (RESOURCE_EXHAUSTED; QUEUE_FULL, or TOO_MANY_OPEN for one user) naming the limit that is
    /// reached.
    Admission admit(const Route& route, std::size_t bytes);
    /// Returns false if the request has been closed meanwhile, because another thread answered it.
    bool attach(Number number, const CallPtr& call);
    void close(Number number);

    /// Returns whether a request of `client` has not been read yet.
    bool has_unread(const std::string& client) const;
    /// Returns the unanswered calls of `client` with this `id`.
    std::vector<CallPtr> find(const std::string& client, const std::string& id) const;
    std::vector<CallPtr> overdue(Call::Clock::time_point now) const;
    Call::Clock::time_point next_deadline() const;

    struct Entry {
        Route route;
        CallPtr call;  ///< null until the request has been read
    };
    /// Returns the open calls of one client, with their numbers.
    std::vector<std::pair<Number, Entry>> of(const std::string& client) const;
    /// Closes all calls.
    std::vector<Entry> take_all();
    std::vector<Entry> all() const;
    std::size_t count() const;
    std::size_t bytes() const { return bytes_; }

   private:
    void check(const Route& route, std::size_t bytes) const;
    void forget(const Entry& entry, Number number);

    const Bounds bounds_;
    std::atomic<std::size_t> bytes_ = 0;
    mutable std::mutex mutex_;
    Number last_ = 0;
    std::map<Number, Entry> entries_;
    std::map<std::string, std::size_t> per_client_, per_user_;
    std::set<std::pair<Call::Clock::time_point, Number>> deadlines_;
};

}  // namespace contactd::server
