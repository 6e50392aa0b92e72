// Tracks connected clients by ZeroMQ's socket events.
#pragma once

#include <string>
#include <vector>
#include <zmq.hpp>

#include "client_connections.hpp"
#include "operation/counters.hpp"
#include "unfinished_input.hpp"

namespace contactd::server {

/// Counts connections, detects disconnected clients, and closes the connections of endless messages. Belongs to the
/// thread of its socket, and must be destroyed before it.
class ConnectionMonitor {
   public:
    using Clock = UnfinishedInput::Clock;

    /// Stores the number of connections in `connections`; `max_input_bytes` is the bound of UnfinishedInput.
    ConnectionMonitor(zmq::context_t& context, zmq::socket_t& watched, std::size_t max_input_bytes,
                      Counters::Count& connections);
    ~ConnectionMonitor();
    ConnectionMonitor(const ConnectionMonitor&) = delete;
    ConnectionMonitor& operator=(const ConnectionMonitor&) = delete;

    /// Returns a descriptor that is readable if there are events.
    void* handle() { return events_.handle(); }
    /// Processes the events.
    void read();
    /// Records a complete message of `client` through the connection `fd`. Returns false if the client has since
    /// disconnected.
    bool note_message(int fd, const std::string& client);
    /// Returns the clients that disconnected since the last call.
    std::vector<std::string> take_gone() { return clients_.take_gone(); }

    /// Limits the bytes of unfinished messages, when a check is due.
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
