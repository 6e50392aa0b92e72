#include "about.hpp"

#include <civetweb.h>
#include <spdlog/version.h>
#include <zmq.h>

#include <CLI/Version.hpp>

#include "contactd/version.hpp"
#include "versions.hpp"

namespace contactd::server {

std::map<std::string, std::string> daemon_library_versions() {
    auto versions = service_library_versions();
    int major = 0, minor = 0, patch = 0;
    zmq_version(&major, &minor, &patch);
    versions["zeromq"] = dotted(major, minor, patch);
    versions["spdlog"] = dotted(SPDLOG_VER_MAJOR, SPDLOG_VER_MINOR, SPDLOG_VER_PATCH);
    versions["cli11"] = CLI11_VERSION;
    versions["civetweb"] = mg_version();
    versions["systemd"] = SYSTEMD_VERSION;
    return versions;
}

std::string about() {
    std::string text = "contactd " + version() + "\ncommit " + commit() + "\n";
    for (const auto& [name, number] : daemon_library_versions()) text += name + " " + number + "\n";
    text.pop_back();
    return text;
}

}  // namespace contactd::server
