#include "client_connections.hpp"

#include <utility>

namespace contactd::server {
namespace {

/// Returns whether ROUTER assigned the identity by counting; identities chosen by clients must not begin with a zero.
bool is_given(const std::string& client) {
    return client.starts_with('\0');
}

}  // namespace

void ClientConnections::note_end(int fd) {
    const auto connection = clients_.find(fd);
    if (connection == clients_.end()) return;
    if (is_given(connection->second)) gone_.push_back(std::move(connection->second));
    clients_.erase(connection);
}

bool ClientConnections::knows(int fd, const std::string& client) const {
    const auto connection = clients_.find(fd);
    return connection != clients_.end() && connection->second == client;
}

bool ClientConnections::note_message(int fd, const std::string& client) {
    const auto connection = clients_.find(fd);
    if (connection == clients_.end()) return !is_given(client);
    connection->second = client;
    return true;
}

std::vector<std::string> ClientConnections::take_gone() {
    return std::exchange(gone_, {});
}

}  // namespace contactd::server
