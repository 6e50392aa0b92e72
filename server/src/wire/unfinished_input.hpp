// Bytes of messages that have not come to their end, which ZeroMQ keeps without bound.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace contactd::server {

/// Counts the bytes that came through each connection since its last whole message, and hangs up on whoever sent the
/// most of them when all together are too many. The kernel counts them, and only for TCP: connections of other kinds
/// are passed over. Belongs to the I/O thread.
class UnfinishedInput {
   public:
    using Clock = std::chrono::steady_clock;

    explicit UnfinishedInput(std::size_t max_bytes) : max_bytes_(max_bytes) {}

    void note_connection(int fd);
    void note_end(int fd);
    /// A message has come whole through `fd`.
    void note_message(int fd);

    /// Counts, when it is time to.
    void enforce(Clock::time_point now);
    /// When that is; never while there is nothing to count.
    Clock::time_point next_look() const { return connections_.empty() ? Clock::time_point::max() : next_look_; }

   private:
    struct Connection {
        std::uint64_t received = 0;      ///< all bytes, at the last look
        std::uint64_t accounted = 0;     ///< of these, bytes of messages that came whole
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
