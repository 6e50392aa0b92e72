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

/// Bytes that ever came through a connection; nothing when `fd` is no TCP socket, or none any more.
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

/// Counts bytes of all connections that no whole message accounts for.
std::uint64_t UnfinishedInput::count() {
    std::uint64_t total = 0;
    for (auto& [fd, connection] : connections_) {
        // Between the end of a connection and the news of it its number may be another file's: that has nothing to say.
        connection.received = received_by(fd).value_or(0);
        // Bytes between the last whole message and now do not count: the next look sees what follows them.
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
    // The close is to be a reset: a sender whose window is shut would not hear of a quiet one for a minute.
    const linger none{.l_onoff = 1, .l_linger = 0};
    ::setsockopt(connection->first, SOL_SOCKET, SO_LINGER, &none, sizeof none);
    // ZeroMQ notices, closes, and gives back what it kept of the message.
    ::shutdown(connection->first, SHUT_RDWR);
    sender.accounted = sender.received;
}

}  // namespace contactd::server
