// Tracks connected clients, and clients that have disconnected.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace contactd::server {

/// A client is the identity that ROUTER assigns to a connection, and it ends with the connection, because nothing can
/// be sent to it any more. An identity chosen by a client does not end, because the client may reconnect with it and
/// receive its answers. Belongs to the I/O thread.
class ClientConnections {
   public:
    void note_connection(int fd) { clients_[fd].clear(); }
    void note_end(int fd);

    /// Returns whether `client` is known to use `fd`. If not, pending events of connections must be processed first,
    /// because the number may have belonged to another connection.
    bool knows(int fd, const std::string& client) const;
    /// Records a message of `client` through `fd`. Returns false if the connection has since ended.
    bool note_message(int fd, const std::string& client);

    /// Returns the clients that disconnected since the last call.
    std::vector<std::string> take_gone();

   private:
    std::unordered_map<int, std::string> clients_;  // by file descriptor; empty before the first message
    std::vector<std::string> gone_;
};

}  // namespace contactd::server
