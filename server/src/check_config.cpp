#include "check_config.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ostream>
#include <string>
#include <vector>
#include <zmq.hpp>

#include "access/curve_keys.hpp"
#include "config/socket_file.hpp"
#include "contactd/error.hpp"
#include "contactd/ic_store.hpp"
#include "operation/builder_programs.hpp"
#include "operation/metrics/http_listener.hpp"

namespace contactd::server {
namespace {

namespace fs = std::filesystem;

/// Holds the subject of a check, and its problem, which is empty if there is none.
struct Finding {
    std::string subject;
    std::string problem;
};

/// Returns the reason why no file can be created in the folder, which may be missing if it can be created.
std::string folder_problem(const std::string& field, fs::path folder) {
    std::error_code error;
    folder = fs::absolute(folder.empty() ? "." : folder, error);
    while (!fs::exists(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
    if (error) return field + ": " + folder.string() + " cannot be inspected: " + error.message() + ".";
    if (!fs::is_directory(folder, error)) return field + ": " + folder.string() + " is not a folder.";
    const std::string why = cannot_write(folder);
    return why.empty() ? why : field + ": the folder " + folder.string() + " is not writable: " + why + ".";
}

std::string ipc_problem(const std::string& endpoint) {
    if (std::string problem = socket_file_problem(endpoint); !problem.empty()) return problem;
    const std::string file = socket_file(endpoint);
    if (file.empty()) return {};  // abstract: no file
    const fs::path folder = fs::path(file).parent_path();
    std::error_code error;
    if (!folder.empty() && !fs::is_directory(folder, error))
        return "endpoint is \"" + endpoint + "\"; the folder " + folder.string() + " does not exist.";
    return folder_problem("endpoint", folder);
}

/// Checks an address by listening there for a moment.
std::string tcp_problem(const std::string& endpoint) {
    try {
        zmq::context_t context;
        zmq::socket_t socket(context, zmq::socket_type::router);
        socket.set(zmq::sockopt::ipv6, endpoint.starts_with("tcp://["));
        socket.bind(endpoint);
        return {};
    } catch (const zmq::error_t& error) {
        return "endpoint is \"" + endpoint + "\"; contactd cannot listen there: " + error.what() + ".";
    }
}

Finding endpoint_finding(const Config& config) {
    const std::string& endpoint = config.endpoint;
    return {"endpoint " + endpoint, endpoint.starts_with("ipc://") ? ipc_problem(endpoint) : tcp_problem(endpoint)};
}

Finding store_finding(const Config& config) {
    const fs::path& folder = config.store.folder;
    std::error_code error;
    if (fs::is_directory(folder, error) && ::access(folder.c_str(), R_OK | X_OK) != 0)
        return {"store.folder",
                "store.folder: the folder " + folder.string() + " cannot be read: " + std::strerror(errno) + "."};
    return {"store.folder " + folder.string(), folder_problem("store.folder", folder)};
}

Finding builder_finding(const Config& config) {
    return {"builds.program " + config.builds.program.string(), builder_problem(config)};
}

Finding launcher_finding(const Config& config) {
    return {"builds.launcher " + config.builds.launcher.front(), launcher_problem(config)};
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
    if (fs::is_directory(file, error)) {
        problem = "log.file is " + file.string() + ", which is a folder.";
    } else if (fs::exists(file, error)) {
        const int fd = ::open(file.c_str(), O_WRONLY | O_APPEND | O_NONBLOCK | O_CLOEXEC);
        if (fd < 0)
            problem = "log.file is " + file.string() + ", which is not writable: " + std::strerror(errno) + ".";
        else
            ::close(fd);
    } else {
        problem = folder_problem("log.file", file.parent_path());
    }
    return {"log.file " + file.string(), problem};
}

/// Checks an address by listening there for a moment.
Finding http_finding(const Config& config) {
    const std::string subject = "http.address " + config.http.address;
    try {
        const HttpListener listener(config.http.address, {});
        return {subject, {}};
    } catch (const Error& error) {
        return {subject, error.what()};
    }
}

}  // namespace

int check_config(const Config& config, std::ostream& good, std::ostream& bad) {
    std::vector<Finding> findings{endpoint_finding(config), store_finding(config), builder_finding(config)};
    if (!config.builds.launcher.empty()) findings.push_back(launcher_finding(config));
    if (!config.security.curve.secret_key_file.empty()) findings.push_back(keys_finding(config));
    if (!config.log.file.empty()) findings.push_back(log_finding(config));
    if (!config.http.address.empty()) findings.push_back(http_finding(config));
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
