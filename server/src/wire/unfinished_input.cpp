#include "unfinished_input.hpp"

#include <linux/tcp.h>
#include <netinet/in.h>
#include <spdlog/spdlog.h>
#include <sys/socket.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace contactd::server {
namespace {

constexpr auto scan_interval = std::chrono::milliseconds(100);

/// Returns all bytes received through a connection, or nothing if `fd` is not a TCP socket.
std::optional<std::uint64_t> received_by(int fd) {
    tcp_info info{};
    socklen_t size = sizeof info;
    if (::getsockopt(fd, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) return std::nullopt;
    return info.tcpi_bytes_received;
}

}  // namespace

void UnfinishedInput::note_connection(int fd) {
    if (received_by(fd)) connections_[fd] = {};
}

void UnfinishedInput::note_end(int fd) {
    connections_.erase(fd);
}

void UnfinishedInput::note_message(int fd) {
    const auto connection = connections_.find(fd);
    if (connection != connections_.end()) connection->second.sent_whole_message = true;
}

/// Counts the bytes of all connections that do not belong to a complete message.
std::uint64_t UnfinishedInput::count() {
    std::uint64_t total = 0;
    for (auto& [fd, connection] : connections_) {
        // Between the end of a connection and its event, the number may belong to another file, which does not count.
        connection.received = received_by(fd).value_or(0);
        // Bytes since the last complete message do not count yet; the next check counts the bytes after them.
        if (std::exchange(connection.sent_whole_message, false) || connection.received < connection.accounted)
            connection.accounted = connection.received;
        total += connection.received - connection.accounted;
    }
    return total;
}

void UnfinishedInput::enforce(Clock::time_point now) {
    if (now < next_look()) return;
    next_look_ = now + scan_interval;
    for (std::uint64_t total = count(); total > max_bytes_;) {
        const auto most = std::max_element(connections_.begin(), connections_.end(), [](const auto& a, const auto& b) {
            return a.second.received - a.second.accounted < b.second.received - b.second.accounted;
        });
        total -= most->second.received - most->second.accounted;
        hang_up(most);
    }
}

void UnfinishedInput::hang_up(const Connections::iterator& connection) {
    Connection& sender = connection->second;
    spdlog::warn("connection closed: {} bytes of an unfinished message exceed limits.max_inbox_bytes",
                 sender.received - sender.accounted);
    // Closes with a reset, because a sender with a closed window would not notice a normal close for a minute.
    const linger none{.l_onoff = 1, .l_linger = 0};
    ::setsockopt(connection->first, SOL_SOCKET, SO_LINGER, &none, sizeof none);
    // ZeroMQ then closes the connection and frees the partial message.
    ::shutdown(connection->first, SHUT_RDWR);
    sender.accounted = sender.received;
}

}  // namespace contactd::server
