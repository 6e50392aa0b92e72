#include "engine/environment.hpp"

#include <string>

#include "contactd/platform.hpp"

namespace contactd::engine {

using platform::variable;

std::filesystem::path default_store_folder() {
    const std::filesystem::path cache = platform::cache_folder();
    return cache.empty() ? cache : cache / "contactd" / "store";
}

EngineSettings settings_of_environment() {
    EngineSettings settings;
    const std::string store = variable("CONTACTD_STORE"), builder = variable("CONTACTD_IC");
    settings.store_folder = store.empty() ? default_store_folder() : std::filesystem::path(store);
    settings.tables.command.program = builder.empty() ? "contactd-ic" : builder;
    settings.tables.command.stall = std::chrono::seconds(60);
    settings.tables.memory_budget_bytes = std::size_t{1} << 28;
    return settings;
}

}  // namespace contactd::engine
