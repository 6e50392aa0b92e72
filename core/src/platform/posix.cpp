// Implements the platform for POSIX and Linux.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

#include "contactd/platform.hpp"

namespace contactd::platform {
namespace {

namespace fs = std::filesystem;

std::error_code last_error() {
    return {errno, std::generic_category()};
}

int flags_of(OpenFile::Use use) {
    switch (use) {
        case OpenFile::Use::reading:
            return O_RDONLY | O_NOFOLLOW | O_NONBLOCK;
        case OpenFile::Use::writing_new:
            return O_WRONLY | O_CREAT | O_EXCL;
        case OpenFile::Use::locking:
            break;
    }
    return O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK;
}

int descriptor(std::intptr_t handle) {
    return static_cast<int>(handle);
}

}  // namespace

OpenFile::OpenFile(const fs::path& path, Use use) : handle_(::open(path.c_str(), flags_of(use) | O_CLOEXEC, 0644)) {
    if (!is_open()) error_ = last_error();
}

OpenFile::~OpenFile() {
    close();
}

OpenFile::OpenFile(OpenFile&& other) noexcept : handle_(std::exchange(other.handle_, none)), error_(other.error_) {}

OpenFile& OpenFile::operator=(OpenFile&& other) noexcept {
    if (this == &other) return *this;
    close();
    handle_ = std::exchange(other.handle_, none);
    error_ = other.error_;
    return *this;
}

void OpenFile::close() noexcept {
    if (is_open()) ::close(descriptor(handle_));
    handle_ = none;
}

bool OpenFile::is_regular() const {
    struct stat opened;
    return ::fstat(descriptor(handle_), &opened) == 0 && S_ISREG(opened.st_mode);
}

std::optional<std::uintmax_t> OpenFile::size() const {
    struct stat opened;
    if (::fstat(descriptor(handle_), &opened) != 0) return std::nullopt;
    return static_cast<std::uintmax_t>(opened.st_size);
}

bool OpenFile::has_name() const {
    struct stat opened;
    return ::fstat(descriptor(handle_), &opened) == 0 && opened.st_nlink > 0;
}

bool OpenFile::is_at(const fs::path& path) const {
    struct stat opened, named;
    return ::fstat(descriptor(handle_), &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

std::optional<std::size_t> OpenFile::read(std::span<unsigned char> bytes) {
    std::size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t got = ::read(descriptor(handle_), bytes.data() + have, bytes.size() - have);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) {
            error_ = last_error();
            return std::nullopt;
        }
        if (got == 0) break;
        have += static_cast<std::size_t>(got);
    }
    return have;
}

bool OpenFile::write(std::span<const unsigned char> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor(handle_), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) {
            error_ = last_error();
            return false;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

bool OpenFile::sync() {
    if (::fsync(descriptor(handle_)) == 0) return true;
    error_ = last_error();
    return false;
}

OpenFile::Lock OpenFile::try_lock() {
    if (::flock(descriptor(handle_), LOCK_EX | LOCK_NB) == 0) return Lock::held;
    error_ = last_error();
    return errno == EWOULDBLOCK || errno == EINTR ? Lock::busy : Lock::unavailable;
}

void OpenFile::note_change() const {
    ::futimens(descriptor(handle_), nullptr);
}

MappedFile::MappedFile(const fs::path& path) {
    const OpenFile file(path, OpenFile::Use::reading);
    const std::optional<std::uintmax_t> size = file.is_open() ? file.size() : std::nullopt;
    if (!size || !file.is_regular()) {
        error_ = file.is_open() ? std::make_error_code(std::errc::invalid_argument) : file.error();
        return;
    }
    if (*size == 0) return;
    const auto length = static_cast<std::size_t>(*size);
    void* const begin = ::mmap(nullptr, length, PROT_READ, MAP_SHARED, descriptor(file.handle_), 0);
    if (begin == MAP_FAILED)
        error_ = last_error();
    else
        bytes_ = {static_cast<const unsigned char*>(begin), length};
}

MappedFile::~MappedFile() {
    if (!bytes_.empty()) ::munmap(const_cast<unsigned char*>(bytes_.data()), bytes_.size());
}

MappedFile::MappedFile(MappedFile&& other) noexcept : bytes_(std::exchange(other.bytes_, {})), error_(other.error_) {}

std::error_code rename_over(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    return error;
}

std::error_code sync_folder(const fs::path& folder) {
    const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (opened < 0) return last_error();
    const std::error_code error = ::fsync(opened) == 0 ? std::error_code() : last_error();
    ::close(opened);
    return error;
}

std::error_code cannot_make_file(const fs::path& folder) {
    std::string name = (folder / ".contactd-XXXXXX").string();
    const int made = ::mkostemp(name.data(), O_CLOEXEC);
    if (made < 0) return last_error();
    ::close(made);
    ::unlink(name.c_str());
    return {};
}

std::error_code cannot_use(const fs::path& folder, bool written) {
    return ::access(folder.c_str(), R_OK | X_OK | (written ? W_OK : 0)) == 0 ? std::error_code() : last_error();
}

std::string boot_name() {
    std::string id;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
    std::erase(id, '-');
    return id.empty() ? "0" : id.substr(0, 12);
}

std::string process_name() {
    return std::to_string(::getpid());
}

std::string start_of(const std::string& process) {
    // The time is in clock ticks since the start of the machine: field 22 of /proc/PROCESS/stat, counted behind the
    // name in brackets.
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

void random_bytes(std::span<unsigned char> bytes) {
    constexpr std::size_t most = 256;  // limit of one call
    for (std::size_t begin = 0; begin < bytes.size(); begin += most) {
        const auto part = bytes.subspan(begin, std::min(most, bytes.size() - begin));
        if (::getentropy(part.data(), part.size()) != 0)
            throw std::system_error(errno, std::generic_category(), "getentropy");
    }
}

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

fs::path cache_folder() {
    if (const std::string cache = variable("XDG_CACHE_HOME"); !cache.empty()) return cache;
    if (const std::string home = variable("HOME"); !home.empty()) return fs::path(home) / ".cache";
    return {};
}

}  // namespace contactd::platform
