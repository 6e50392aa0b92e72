// Reports the contents and the usability of the store's folder.
#pragma once

#include <filesystem>
#include <string>

#include "engine/operation/engine_counters.hpp"

namespace contactd::engine {

/// Sets counters.store_tables and store_bytes to the current contents, or to zero if the folder cannot be read.
void count_store(EngineCounters& counters, const std::filesystem::path& folder);

/// Returns the reason why tables cannot be stored in the folder, as a sentence; empty if they can.
std::string store_problem(const std::filesystem::path& folder);

}  // namespace contactd::engine
