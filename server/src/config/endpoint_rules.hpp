// Rules of endpoints: what only this machine can reach needs no keys, everything else does; and where the daemon may
// write its log.
#pragma once

#include <string>

#include "config.hpp"

namespace contactd::server {

/// True for ipc and for numeric loopback addresses (127.0.0.0/8, [::1]). Names, interfaces and wildcards could be
/// anything, so they are not.
bool is_local(const std::string& endpoint);

/// A tcp endpoint whose host is a name, such as localhost, of which every address is a loopback: with the number in its
/// place, so that nobody asks a resolver again. Any other endpoint as it is.
std::string with_loopback_number(const std::string& endpoint);

/// Throws contactd::Error when the configured endpoint can be reached from other machines, is not encrypted, and nobody
/// stated that this is meant; or when CURVE is configured by half.
void check_endpoint(const Config& config);

/// Throws contactd::Error when the log would be written into what the daemon keeps or reads: the store, keys, programs.
void check_log_file(const Config& config);

}  // namespace contactd::server
