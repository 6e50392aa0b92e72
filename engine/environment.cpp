#include "engine/environment.hpp"

#include <cstdlib>
#include <string>

namespace contactd::engine {

namespace {

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

}  // namespace

std::filesystem::path default_store_folder() {
    if (const std::string cache = variable("XDG_CACHE_HOME"); !cache.empty())
        return std::filesystem::path(cache) / "contactd" / "store";
    if (const std::string home = variable("HOME"); !home.empty())
        return std::filesystem::path(home) / ".cache" / "contactd" / "store";
    return {};
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
