// Checks endpoints: addresses that only this machine can reach need no keys, all others do. Also checks the log file.
#pragma once

#include <string>

#include "config.hpp"

namespace contactd::server {

/// Returns true for ipc and for numeric loopback addresses (127.0.0.0/8, [::1]), and false for names, interfaces and
/// wildcards, which may be any address.
bool is_local(const std::string& endpoint);

/// Returns a tcp endpoint with the number instead of the host's name if all addresses of the name are loopback
/// addresses, as for localhost, so that no resolver is asked again. Returns other endpoints unchanged.
std::string with_loopback_number(const std::string& endpoint);

/// Throws contactd::Error if the configured endpoint can be reached from other machines without encryption and this is
/// not explicitly allowed, or if CURVE is configured incompletely.
void check_endpoint(const Config& config);

/// Throws contactd::Error if the log would be written into other files of the daemon: the store, keys, programs.
void check_log_file(const Config& config);

}  // namespace contactd::server
