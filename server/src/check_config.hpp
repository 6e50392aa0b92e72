// contactd --check-config: reports what would fail at the start, before it does.
#pragma once

#include <iosfwd>

#include "config/config.hpp"

namespace contactd::server {

/// Writes a line for each thing that was looked at: "ok: ..." to `good`, a sentence to `bad` where something is wrong.
/// Returns the number of problems. Starts nothing, listens nowhere, and leaves no file behind.
int check_config(const Config& config, std::ostream& good, std::ostream& bad);

}  // namespace contactd::server
