// The program that the service runs in: the daemon, or one that has it in process.
#pragma once

#include <map>
#include <string>

#include "engine/operation/engine_log.hpp"

namespace contactd::server {

struct Host {
    std::map<std::string, std::string> libraries;  ///< versions of what it links
    engine::LogSink log{};
    /// Each call comes from a thread that does nothing but wait for its answer, and may do small solves itself,
    /// whoever else asks.
    bool callers_wait = false;
};

}  // namespace contactd::server
