#include "check_config.hpp"

#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "access/curve_keys.hpp"
#include "ics/store_folder.hpp"

namespace contactd::server {
namespace {

namespace fs = std::filesystem;

/// What was looked at and, when something is wrong, what; empty: all is well.
struct Finding {
    std::string subject;
    std::string problem;
};

/// Why no file can be made in the folder, which may be missing when it can be made.
std::string folder_problem(const std::string& field, fs::path folder) {
    if (folder.empty()) folder = ".";
    std::error_code error;
    if (fs::exists(folder, error)) {
        if (!fs::is_directory(folder, error)) return field + ": " + folder.string() + " is no folder.";
        if (::access(folder.c_str(), W_OK | X_OK) != 0)
            return field + ": the folder " + folder.string() + " cannot be written to: " + std::strerror(errno) + ".";
        return {};
    }
    if (error) return field + ": " + folder.string() + " cannot be looked at: " + error.message() + ".";
    const fs::path parent = fs::absolute(folder, error).parent_path();
    return folder_problem(field, parent);
}

std::string ipc_problem(const std::string& endpoint, const std::string& path) {
    constexpr std::size_t longest = sizeof(sockaddr_un::sun_path) - 1;
    if (path.size() > longest)
        return "endpoint is \"" + endpoint + "\"; the path has " + std::to_string(path.size()) +
               " characters, at most " + std::to_string(longest) + " are possible.";
    if (path.starts_with("@")) return {};  // abstract: no file
    const fs::path folder = fs::path(path).parent_path();
    std::error_code error;
    if (!folder.empty() && !fs::is_directory(folder, error))
        return "endpoint is \"" + endpoint + "\"; the folder " + folder.string() + " does not exist.";
    return folder_problem("endpoint", folder);
}

/// The form of a tcp endpoint was checked with the configuration's schema.
Finding endpoint_finding(const Config& config) {
    constexpr std::string_view ipc = "ipc://";
    const std::string& endpoint = config.endpoint;
    return {"endpoint " + endpoint,
            endpoint.starts_with(ipc) ? ipc_problem(endpoint, endpoint.substr(ipc.size())) : std::string()};
}

Finding store_finding(const Config& config) {
    const fs::path& folder = config.store.folder;
    std::error_code error;
    return {"store.folder " + folder.string(),
            fs::is_directory(folder, error) ? store_problem(folder) : folder_problem("store.folder", folder)};
}

bool is_program(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

Finding builder_finding(const Config& config) {
    const fs::path& program = config.builds.program;
    return {"builds.program " + program.string(),
            is_program(program) ? std::string()
                                : "builds.program is " + program.string() +
                                      "; there is no program of that name that may be run, so no table can be built."};
}

/// As execvp would find it.
bool is_on_path(const std::string& name) {
    if (name.find('/') != std::string::npos) return is_program(name);
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (is_program(fs::path(folder.empty() ? "." : folder) / name)) return true;
    return false;
}

Finding launcher_finding(const Config& config) {
    const std::string& name = config.builds.launcher.front();
    return {"builds.launcher " + name,
            is_on_path(name) ? std::string()
                             : "builds.launcher starts with \"" + name + "\"; no such program is found on PATH."};
}

Finding keys_finding(const Config& config) {
    const auto& curve = config.security.curve;
    std::vector<std::string> problems;
    try {
        read_secret_key(curve.secret_key_file);
        AllowedKeys::read(curve.allowed_keys, problems);
    } catch (const std::exception& error) {
        problems.emplace_back(error.what());
    }
    std::string sentences;
    for (const std::string& problem : problems) sentences += (sentences.empty() ? "" : "\n") + problem;
    return {"security.curve " + curve.allowed_keys.string(), sentences};
}

Finding log_finding(const Config& config) {
    const fs::path& file = config.log.file;
    std::error_code error;
    std::string problem;
    if (fs::is_directory(file, error))
        problem = "log.file is " + file.string() + ", which is a folder.";
    else if (fs::exists(file, error) && ::access(file.c_str(), W_OK) != 0)
        problem = "log.file is " + file.string() + ", which cannot be written to: " + std::strerror(errno) + ".";
    else if (!fs::exists(file, error))
        problem = folder_problem("log.file", file.parent_path());
    return {"log.file " + file.string(), problem};
}

}  // namespace

int check_config(const Config& config, std::ostream& good, std::ostream& bad) {
    std::vector<Finding> findings{endpoint_finding(config), store_finding(config), builder_finding(config)};
    if (!config.builds.launcher.empty()) findings.push_back(launcher_finding(config));
    if (!config.security.curve.secret_key_file.empty()) findings.push_back(keys_finding(config));
    if (!config.log.file.empty()) findings.push_back(log_finding(config));
    if (!config.http.address.empty()) findings.push_back({"http.address " + config.http.address, {}});
    int problems = 0;
    for (const auto& [subject, problem] : findings) {
        if (problem.empty())
            good << "ok: " << subject << "\n";
        else
            bad << problem << "\n";
        problems += !problem.empty();
    }
    return problems;
}

}  // namespace contactd::server
