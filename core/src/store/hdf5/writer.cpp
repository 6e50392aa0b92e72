#include "writer.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

namespace contactd {
namespace {

namespace fs = std::filesystem;

struct Writer {
    std::string boot, process, start, host;
};

std::string boot_id() {
    std::string id;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
    std::erase(id, '-');
    return id.empty() ? "0" : id.substr(0, 12);
}

/// In clock ticks since the machine started: field 22 of /proc/PROCESS/stat, counted behind the name in brackets.
std::string start_time(const std::string& process) {
    std::ifstream file("/proc/" + process + "/stat");
    std::stringstream text;
    text << file.rdbuf();
    const std::string line = text.str();
    const std::size_t behind_name = line.rfind(')');
    if (behind_name == std::string::npos) return "0";
    std::istringstream fields(line.substr(behind_name + 1));
    std::string field = "0";
    for (int n = 3; n <= 22; ++n) fields >> field;
    return field;
}

std::string host_name() {
    std::array<char, 65> name{};
    ::gethostname(name.data(), name.size() - 1);
    std::string host = name.data();
    std::replace_if(host.begin(), host.end(), [](char c) { return c == '/' || c == '.'; }, '_');
    return host;
}

/// Reads the writer from "<table>.<writer>.<serial>.tmp".
std::optional<Writer> writer_of(const fs::path& temporary) {
    const std::string writer = temporary.stem().stem().extension().string();
    if (writer.empty()) return std::nullopt;
    std::istringstream text(writer.substr(1));
    Writer read;
    const bool whole = std::getline(text, read.boot, '-') && std::getline(text, read.process, '-') &&
                       std::getline(text, read.start, '-') && std::getline(text, read.host);
    return whole ? std::optional<Writer>(read) : std::nullopt;
}

enum class Lock { free, held, unknown };

Lock lock_of(const fs::path& path) {
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (fd < 0) return Lock::unknown;
    const bool locked = ::flock(fd, LOCK_EX | LOCK_NB) == 0;
    const int error = errno;
    ::close(fd);
    if (locked) return Lock::free;
    return error == EWOULDBLOCK ? Lock::held : Lock::unknown;
}

}  // namespace

const std::string& writer_name() {
    static const std::string name = [] {
        const std::string process = std::to_string(::getpid());
        return boot_id() + "-" + process + "-" + start_time(process) + "-" + host_name();
    }();
    return name;
}

bool is_abandoned(const fs::path& temporary) {
    const Lock lock = lock_of(temporary);
    if (lock == Lock::held) return false;
    const std::optional<Writer> writer = writer_of(temporary);
    if (!writer) return lock == Lock::free;
    if (writer->boot != boot_id()) return writer->host == host_name();  // this machine has been started again since
    return lock == Lock::free || start_time(writer->process) != writer->start;
}

}  // namespace contactd
