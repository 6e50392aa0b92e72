// The state of the daemon, and who watches it.
#pragma once

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

   private:
    mutable std::mutex mutex_;
    HealthState state_ = HealthState::serving;
    std::vector<CallPtr> watchers_;
};

}  // namespace contactd::server
