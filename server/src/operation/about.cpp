#include "about.hpp"

#include <civetweb.h>
#include <spdlog/version.h>
#include <zmq.h>

#include <CLI/Version.hpp>
#include <nlohmann/json.hpp>

#include "commit.hpp"
#include "contactd/version.hpp"

namespace contactd::server {
namespace {

template <class... Numbers>
std::string dotted(int first, Numbers... rest) {
    return (std::to_string(first) + ... + ("." + std::to_string(rest)));
}

}  // namespace

std::string commit() {
    return commit_text;
}

std::map<std::string, std::string> all_library_versions() {
    auto versions = library_versions();
    int major = 0, minor = 0, patch = 0;
    zmq_version(&major, &minor, &patch);
    versions["zeromq"] = dotted(major, minor, patch);
    versions["spdlog"] = dotted(SPDLOG_VER_MAJOR, SPDLOG_VER_MINOR, SPDLOG_VER_PATCH);
    versions["nlohmann-json"] =
        dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH);
    versions["cli11"] = CLI11_VERSION;
    versions["civetweb"] = mg_version();
    versions["prometheus-cpp"] = PROMETHEUS_CPP_VERSION;
    versions["reproc"] = REPROC_VERSION;
    versions["systemd"] = SYSTEMD_VERSION;
    return versions;
}

std::string about() {
    std::string text = "contactd " + version() + "\ncommit " + commit() + "\n";
    for (const auto& [name, number] : all_library_versions()) text += name + " " + number + "\n";
    text.pop_back();
    return text;
}

}  // namespace contactd::server
