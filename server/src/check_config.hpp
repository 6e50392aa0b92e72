// contactd --check-config: reports problems that would make the start fail.
#pragma once

#include <iosfwd>

#include "config/config.hpp"

namespace contactd::server {

/// Writes a line for each check: "ok: ..." to `good`, or a sentence with the problem to `bad`. Returns the number of
/// problems. Starts no service and leaves no files behind.
int check_config(const Config& config, std::ostream& good, std::ostream& bad);

}  // namespace contactd::server
