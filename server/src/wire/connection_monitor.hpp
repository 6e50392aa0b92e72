// Who is connected, from what ZeroMQ says of its socket.
#pragma once

#include <zmq.hpp>

#include "client_connections.hpp"
#include "operation/counters.hpp"
#include "unfinished_input.hpp"

namespace contactd::server {

/// Belongs to the thread of the socket it watches, and must go before it.
class ConnectionMonitor {
   public:
    ConnectionMonitor(zmq::context_t& context, zmq::socket_t& watched);
    ~ConnectionMonitor();
    ConnectionMonitor(const ConnectionMonitor&) = delete;
    ConnectionMonitor& operator=(const ConnectionMonitor&) = delete;

    /// Readable when there is news.
    void* handle() { return events_.handle(); }
    /// Takes the news in.
    void read(Counters::Count& connections, UnfinishedInput& input, ClientConnections& clients);

   private:
    zmq::socket_t& watched_;
    zmq::socket_t events_;
};

}  // namespace contactd::server
