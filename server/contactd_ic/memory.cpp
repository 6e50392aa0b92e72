#include "memory.hpp"

#include <sys/sysinfo.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace contactd::ic {
namespace {

/// Returns the lowest memory limit of the control group at `path` (as in /proc/self/cgroup) and of its ancestors.
std::uint64_t group_limit(const std::string& path, std::uint64_t most) {
    const std::filesystem::path root = "/sys/fs/cgroup";
    for (std::filesystem::path group = root / std::filesystem::path(path).relative_path();;
         group = group.parent_path()) {
        std::uint64_t bytes = 0;
        if (std::ifstream file(group / "memory.max"); file >> bytes) most = std::min(most, bytes);  // or "max"
        if (group == root || !group.has_relative_path()) return most;
    }
}

}  // namespace

std::uint64_t resident_bytes(const std::vector<pid_t>& processes) {
    static const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    std::uint64_t pages = 0;
    for (const pid_t process : processes) {
        std::uint64_t total = 0, resident = 0;
        if (std::ifstream file("/proc/" + std::to_string(process) + "/statm"); file >> total >> resident)
            pages += resident;
    }
    return pages * page;
}

std::uint64_t machine_memory() {
    struct sysinfo machine{};
    ::sysinfo(&machine);
    std::uint64_t most = static_cast<std::uint64_t>(machine.totalram) * machine.mem_unit;
    std::ifstream groups("/proc/self/cgroup");
    constexpr std::string_view version_2 = "0::";
    for (std::string line; std::getline(groups, line);)
        if (line.starts_with(version_2)) most = group_limit(line.substr(version_2.size()), most);
    return most;
}

void volunteer_for_the_kernel() {
    std::ofstream("/proc/self/oom_score_adj") << 1000;
}

}  // namespace contactd::ic
