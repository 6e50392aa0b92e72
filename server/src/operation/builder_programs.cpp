#include "builder_programs.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace contactd::server {
namespace {

namespace fs = std::filesystem;

bool is_program(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

/// Returns whether execvp would find the program.
bool is_found(const std::string& name) {
    if (name.find('/') != std::string::npos) return is_program(name);
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (is_program(fs::path(folder.empty() ? "." : folder) / name)) return true;
    return false;
}

}  // namespace

std::string builder_problem(const Config& config) {
    const std::string program = config.builds.program.string();
    if (is_found(program)) return {};
    return "builds.program is " + program +
           ", which is not an executable program, so no table can be built: install contactd-ic, or correct the path.";
}

std::string launcher_problem(const Config& config) {
    const auto& launcher = config.builds.launcher;
    if (launcher.empty() || is_found(launcher.front())) return {};
    return "builds.launcher starts with \"" + launcher.front() + "\", which is not on PATH, so no table can be built.";
}

std::vector<std::string> building_problems(const Config& config) {
    std::vector<std::string> problems;
    for (std::string problem : {builder_problem(config), launcher_problem(config)})
        if (!problem.empty()) problems.push_back(std::move(problem));
    return problems;
}

}  // namespace contactd::server
