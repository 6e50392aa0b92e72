// The contents of the store's folder, and whether it can be used.
#pragma once

#include <filesystem>
#include <string>

#include "engine/operation/engine_counters.hpp"

namespace contactd::engine {

/// Sets counters.store_tables and store_bytes to what is there now; zero when the folder cannot be read.
void count_store(EngineCounters& counters, const std::filesystem::path& folder);

/// Why tables cannot be kept in the folder, a sentence; empty when they can.
std::string store_problem(const std::filesystem::path& folder);

}  // namespace contactd::engine
