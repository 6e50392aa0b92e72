// An engine for whoever links it: settings by the variables of the environment.
#pragma once

#include <filesystem>

#include "engine/engine.hpp"

namespace contactd::engine {

/// ${XDG_CACHE_HOME:-~/.cache}/contactd/store, which daemons use too; empty when neither variable is set.
std::filesystem::path default_store_folder();

/// CONTACTD_STORE is the folder of tables (default_store_folder), CONTACTD_IC the builder (contactd-ic, as PATH finds
/// it). The rest is what the daemon has without a configuration.
EngineSettings settings_of_environment();

}  // namespace contactd::engine
