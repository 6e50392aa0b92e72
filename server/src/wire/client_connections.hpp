// Clients at the other end of connections, and clients that have gone.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace contactd::server {

/// A client is the identity that ROUTER gives a connection: it ends with the connection, since nothing can be sent to
/// it any more. An identity that a client chose itself does not: it may come back under it, and gets the answers then.
/// Belongs to the I/O thread.
class ClientConnections {
   public:
    void note_connection(int fd) { clients_[fd].clear(); }
    void note_end(int fd);

    /// Whether `client` is known to speak through `fd`. Where it is not, what happened to connections before has to be
    /// noted first: the number may have been another connection's until now.
    bool knows(int fd, const std::string& client) const;
    /// A message of `client` has come through `fd`. False when the connection has ended since.
    bool note_message(int fd, const std::string& client);

    /// The clients that have gone since the last call.
    std::vector<std::string> take_gone();

   private:
    std::unordered_map<int, std::string> clients_;  // by file descriptor; empty before the first message
    std::vector<std::string> gone_;
};

}  // namespace contactd::server
