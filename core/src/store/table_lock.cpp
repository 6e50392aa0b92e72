#include "contactd/table_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace contactd {
namespace {

/// False of a FIFO or a device, which somebody may have put there.
bool is_file(int fd) {
    struct stat opened;
    return ::fstat(fd, &opened) == 0 && S_ISREG(opened.st_mode);
}

/// False when the file was removed, or another took its name, between opening and locking it.
bool is_still(int fd, const std::filesystem::path& path) {
    struct stat opened, named;
    return ::fstat(fd, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

}  // namespace

TableLock::~TableLock() {
    if (fd_ < 0) return;
    ::unlink(path_.c_str());  // while it is locked, so that nobody else holds what is removed
    ::close(fd_);
}

TableLock::State TableLock::try_lock() {
    constexpr int tries = 16;
    for (int n = 0; n < tries; ++n) {
        const int fd = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0644);
        if (fd < 0 || !is_file(fd)) {
            if (fd >= 0) ::close(fd);
            return State::unavailable;
        }
        if (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
            const bool busy = errno == EWOULDBLOCK || errno == EINTR;
            ::close(fd);
            return busy ? State::busy : State::unavailable;
        }
        if (is_still(fd, path_)) {
            fd_ = fd;
            return State::held;
        }
        ::close(fd);
    }
    return State::busy;
}

void TableLock::give_sign() const {
    if (fd_ >= 0) ::futimens(fd_, nullptr);
}

std::optional<TableLock::Sign> TableLock::sign() const {
    std::error_code error;
    const Sign time = std::filesystem::last_write_time(path_, error);
    return error ? std::nullopt : std::optional<Sign>(time);
}

}  // namespace contactd
