// The state of the daemon, and who watches it.
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
    /// Tells everybody who watches. "stopping" is the last state: it answers them.
    void set(HealthState state);
    /// Sends the state now and with each change; answers once the daemon stops.
    void watch(const CallPtr& call);

    /// From now on requests are heard.
    void set_listening() { listening_ = true; }
    /// Why requests should not be sent here at present, a sentence; empty when all is well.
    std::string not_ready() const;

   private:
    mutable std::mutex mutex_;
    HealthState state_ = HealthState::serving;
    std::vector<CallPtr> watchers_;
    std::atomic<bool> listening_ = false;
};

}  // namespace contactd::server
