// Passes values from any thread to one thread that waits in a poll loop.
#pragma once

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

namespace contactd::server {

template <class T>
class Mailbox {
   public:
    Mailbox() : fd_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
        if (fd_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
    }
    ~Mailbox() { ::close(fd_); }
    Mailbox(const Mailbox&) = delete;
    Mailbox& operator=(const Mailbox&) = delete;

    /// Returns a descriptor that becomes readable if there are values.
    int fd() const { return fd_; }

    void put(T value) {
        {
            const std::scoped_lock lock(mutex_);
            mail_.push_back(std::move(value));
        }
        wake();
    }

    /// Makes fd() readable without a value.
    void wake() {
        const std::uint64_t one = 1;
        // Fails only if the counter is full, in which case the reader is awake anyway.
        [[maybe_unused]] const ssize_t written = ::write(fd_, &one, sizeof one);
    }

    std::vector<T> take_all() {
        std::uint64_t count;
        [[maybe_unused]] const ssize_t got = ::read(fd_, &count, sizeof count);
        const std::scoped_lock lock(mutex_);
        return std::exchange(mail_, {});
    }

    bool empty() const {
        const std::scoped_lock lock(mutex_);
        return mail_.empty();
    }

   private:
    int fd_;
    mutable std::mutex mutex_;
    std::vector<T> mail_;
};

}  // namespace contactd::server
