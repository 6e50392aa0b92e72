#include "writer.hpp"

#include <optional>
#include <sstream>

#include "contactd/platform.hpp"

namespace contactd {
namespace {

namespace fs = std::filesystem;

struct Writer {
    std::string boot, process, start, host;
};

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
    platform::OpenFile file(path, platform::OpenFile::Use::reading);
    if (!file.is_open()) return Lock::unknown;
    switch (file.try_lock()) {
        case platform::OpenFile::Lock::held:
            return Lock::free;
        case platform::OpenFile::Lock::busy:
            return Lock::held;
        case platform::OpenFile::Lock::unavailable:
            break;
    }
    return Lock::unknown;
}

}  // namespace

const std::string& writer_name() {
    static const std::string name = [] {
        const std::string process = platform::process_name();
        return platform::boot_name() + "-" + process + "-" + platform::start_of(process) + "-" + platform::host_name();
    }();
    return name;
}

bool is_abandoned(const fs::path& temporary) {
    const Lock lock = lock_of(temporary);
    if (lock == Lock::held) return false;
    const std::optional<Writer> writer = writer_of(temporary);
    if (!writer) return lock == Lock::free;
    if (writer->boot != platform::boot_name())
        return writer->host == platform::host_name();  // whether this machine has been restarted since
    return lock == Lock::free || platform::start_of(writer->process) != writer->start;
}

}  // namespace contactd
