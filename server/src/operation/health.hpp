// Reports the state of the daemon to its watchers.
#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

#include "jobs/call.hpp"

namespace contactd::server {

enum class HealthState { serving, stopping };
std::string_view name_of(HealthState state);

/// Thread-safe.
class Health {
   public:
    HealthState state() const;
    /// Reports the state to all watchers. "stopping" is the last state and answers them.
    void set(HealthState state);
    /// Sends the state now and with each change; answers once the daemon stops.
    void watch(const CallPtr& call);

    /// Marks the daemon as listening.
    void set_listening() { listening_ = true; }
    /// Returns the reason why requests should not be sent here at present, as a sentence; empty if they can.
    std::string not_ready() const;

   private:
    mutable std::mutex mutex_;
    HealthState state_ = HealthState::serving;
    std::vector<CallPtr> watchers_;
    std::atomic<bool> listening_ = false;
};

}  // namespace contactd::server
