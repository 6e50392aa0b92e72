// contactd --ping: asks a daemon whether it serves, for health checks that have no client at hand.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace contactd::server {

/// Keys of an encrypted connection: the file with the daemon's public key, and that with an allowed pair. Neither is
/// given for a daemon that does not encrypt.
struct PingKeys {
    std::filesystem::path server, own;
};

/// "serving", "stopping", or why there was no answer; `serving` says which.
struct PingResult {
    bool serving;
    std::string text;
};
PingResult ping(const std::string& endpoint, const PingKeys& keys, std::chrono::milliseconds timeout);

}  // namespace contactd::server
