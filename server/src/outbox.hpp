// Sends answers through a ROUTER socket without ever waiting for a slow client.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <zmq.hpp>

#include "call.hpp"

namespace contactd::server {

/// Belongs to the I/O thread, like the socket. What cannot be sent at once is kept, per client and within bounds:
/// progress is dropped first, and a client that lets its answers pile up loses them.
class Outbox {
   public:
    /// `socket` is a ROUTER with ROUTER_MANDATORY set; it must outlive the outbox.
    Outbox(zmq::socket_t& socket, std::size_t max_bytes_per_client)
        : socket_(socket), max_bytes_per_client_(max_bytes_per_client) {}

    void send(Answer answer);
    /// Tries what was kept again.
    void flush();
    bool empty() const { return backlogs_.empty(); }

   private:
    enum class Sent { yes, later, never };
    struct Backlog {
        std::deque<Answer> answers;
        std::size_t bytes = 0;
    };

    Sent try_send(const Answer& answer);

    zmq::socket_t& socket_;
    const std::size_t max_bytes_per_client_;
    std::map<std::string, Backlog> backlogs_;  // by client identity
};

}  // namespace contactd::server
