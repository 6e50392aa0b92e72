// Limits the bytes of unfinished messages, which ZeroMQ buffers without limit.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace contactd::server {

/// Counts the bytes received through each connection since its last complete message. If the total is too large, closes
/// the connection with the most of them. The kernel counts bytes for TCP only; other connections are ignored. Belongs
/// to the I/O thread.
class UnfinishedInput {
   public:
    using Clock = std::chrono::steady_clock;

    explicit UnfinishedInput(std::size_t max_bytes) : max_bytes_(max_bytes) {}

    void note_connection(int fd);
    void note_end(int fd);
    /// Records a complete message through `fd`.
    void note_message(int fd);

    /// Counts the bytes, if a check is due.
    void enforce(Clock::time_point now);
    /// Returns the time of the next check; never if there is nothing to count.
    Clock::time_point next_look() const { return connections_.empty() ? Clock::time_point::max() : next_look_; }

   private:
    struct Connection {
        std::uint64_t received = 0;      ///< all bytes at the last check
        std::uint64_t accounted = 0;     ///< bytes of complete messages among them
        bool sent_whole_message = true;  ///< since the last look
    };
    using Connections = std::unordered_map<int, Connection>;  // by file descriptor

    std::uint64_t count();
    void hang_up(const Connections::iterator& connection);

    const std::size_t max_bytes_;
    Connections connections_;
    Clock::time_point next_look_{};
};

}  // namespace contactd::server
