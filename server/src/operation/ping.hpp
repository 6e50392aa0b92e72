// contactd --ping: asks a daemon whether it is serving, for health checks without a client.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace contactd::server {

/// Names the keys of an encrypted connection: the file with the daemon's public key, and the file with an allowed pair.
/// Both are empty for an unencrypted daemon.
struct PingKeys {
    std::filesystem::path server, own;
};

/// Holds "serving", "stopping", or the reason why there was no answer; `serving` is true for the first.
struct PingResult {
    bool serving;
    std::string text;
};
PingResult ping(const std::string& endpoint, const PingKeys& keys, std::chrono::milliseconds timeout);

}  // namespace contactd::server
