// Sends answers through a ROUTER socket without ever waiting for a slow client.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <zmq.hpp>

#include "jobs/call.hpp"

namespace contactd::server {

/// Belongs to the I/O thread, like the socket. Answers that cannot be sent immediately are kept, in order and within a
/// budget for all clients together. Progress is dropped first. If answers exceed the budget, the client with the most
/// queued answers loses them.
class Outbox {
   public:
    /// `socket` is a ROUTER with ROUTER_MANDATORY set; it must outlive the outbox.
    Outbox(zmq::socket_t& socket, std::size_t max_bytes) : socket_(socket), max_bytes_(max_bytes) {}

    void send(Answer answer);
    /// Retries kept answers.
    void flush();
    bool empty() const { return backlogs_.empty(); }
    /// Returns the bytes queued for slow clients.
    std::size_t bytes() const { return bytes_; }

   private:
    enum class Sent { yes, later, never };
    struct Backlog {
        std::deque<Answer> answers;
        std::size_t bytes = 0;
    };
    using Backlogs = std::map<std::string, Backlog>;  // by client identity

    /// Moves the answer if it is sent; otherwise leaves it unchanged.
    Sent try_send(Answer& answer);
    void keep(Answer answer);
    Backlogs::iterator drop(Backlogs::iterator client);

    zmq::socket_t& socket_;
    const std::size_t max_bytes_;
    std::size_t bytes_ = 0;
    Backlogs backlogs_;
};

}  // namespace contactd::server
