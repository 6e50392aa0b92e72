// Creates an engine for programs that link it, configured by environment variables.
#pragma once

#include <filesystem>

#include "engine/engine.hpp"

namespace contactd::engine {

/// Returns ${XDG_CACHE_HOME:-~/.cache}/contactd/store, which daemons also use, or an empty path if neither variable is
/// set.
std::filesystem::path default_store_folder();

/// CONTACTD_STORE is the folder of tables (default_store_folder), CONTACTD_IC the builder (contactd-ic, as PATH finds
/// it). All other settings are those of a daemon without a configuration.
EngineSettings settings_of_environment();

}  // namespace contactd::engine
