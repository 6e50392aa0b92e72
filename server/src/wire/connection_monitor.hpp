// Connected clients, from what ZeroMQ reports of its socket.
#pragma once

#include <string>
#include <vector>
#include <zmq.hpp>

#include "client_connections.hpp"
#include "operation/counters.hpp"
#include "unfinished_input.hpp"

namespace contactd::server {

/// Counts connections, knows which clients have gone, and hangs up on those that send without end. Belongs to the
/// thread of the socket it watches, and must go before it.
class ConnectionMonitor {
   public:
    using Clock = UnfinishedInput::Clock;

    /// `connections` shows how many there are; `max_input_bytes` is the bound of UnfinishedInput.
    ConnectionMonitor(zmq::context_t& context, zmq::socket_t& watched, std::size_t max_input_bytes,
                      Counters::Count& connections);
    ~ConnectionMonitor();
    ConnectionMonitor(const ConnectionMonitor&) = delete;
    ConnectionMonitor& operator=(const ConnectionMonitor&) = delete;

    /// Readable when there is news.
    void* handle() { return events_.handle(); }
    /// Takes the news in.
    void read();
    /// A message of `client` has come whole through the connection `fd`. False when the client has gone since.
    bool note_message(int fd, const std::string& client);
    /// The clients that have gone since the last call.
    std::vector<std::string> take_gone() { return clients_.take_gone(); }

    /// Bounds what clients have sent of messages without end, when it is time to look.
    void bound_input(Clock::time_point now) { input_.enforce(now); }
    Clock::time_point next_look() const { return input_.next_look(); }

   private:
    zmq::socket_t& watched_;
    zmq::socket_t events_;
    Counters::Count& connections_;
    UnfinishedInput input_;
    ClientConnections clients_;
};

}  // namespace contactd::server
