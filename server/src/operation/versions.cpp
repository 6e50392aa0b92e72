#include "versions.hpp"

#include <nlohmann/json.hpp>

#include "commit.hpp"
#include "contactd/version.hpp"

namespace contactd::server {

std::string commit() {
    return commit_text;
}

std::map<std::string, std::string> service_library_versions() {
    auto versions = library_versions();
    versions["nlohmann-json"] =
        dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH);
    versions["prometheus-cpp"] = PROMETHEUS_CPP_VERSION;
#ifdef REPROC_VERSION  // what starts the builder
    versions["reproc"] = REPROC_VERSION;
#endif
    return versions;
}

}  // namespace contactd::server
