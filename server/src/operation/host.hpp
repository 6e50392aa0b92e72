// Describes the program that runs the service: the daemon, or a program that solves in process.
#pragma once

#include <map>
#include <string>

#include "engine/operation/engine_log.hpp"

namespace contactd::server {

struct Host {
    std::map<std::string, std::string> libraries;  ///< versions of the linked libraries
    engine::LogSink log{};
    /// Each call comes from a thread that only waits for its answer, so small solves may run in this thread, even if
    /// other requests are open.
    bool callers_wait = false;
};

}  // namespace contactd::server
