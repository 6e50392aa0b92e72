// contactd --ping: asks a daemon whether it serves, for health checks that have no client at hand.
#pragma once

#include <chrono>
#include <string>

namespace contactd::server {

/// "serving", "stopping", or why there was no answer; `serving` says which.
struct PingResult {
    bool serving;
    std::string text;
};
PingResult ping(const std::string& endpoint, std::chrono::milliseconds patience);

}  // namespace contactd::server
