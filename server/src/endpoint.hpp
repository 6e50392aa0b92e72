// The I/O thread: owns the ROUTER socket, takes requests in and sends answers out.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>
#include <zmq.hpp>

#include "call.hpp"
#include "config.hpp"
#include "mailbox.hpp"
#include "outbox.hpp"
#include "service.hpp"

namespace contactd::server {

class Endpoint {
   public:
    /// Binds. Throws Error when the address cannot be used.
    Endpoint(const Config& config, Service& service);
    ~Endpoint();

    /// Where clients connect, with the port that was taken.
    std::string address() const;

    /// Serves until a signal arrives at `signal_fd` (a signalfd), then answers what is open and ends all work.
    void run(int signal_fd);

   private:
    void receive();
    void accept(Route route, std::string envelope, std::vector<std::string> frames);
    void open_call(Route route, proto::Request request, Call::Clock::time_point received);
    void deliver();
    void end_overdue();
    long poll_milliseconds();
    void stop();

    const Config& config_;
    Service& service_;
    Mailbox<Answer> mailbox_;
    zmq::context_t context_;
    zmq::socket_t socket_;
    Outbox outbox_;
    std::mutex mutex_;
    std::vector<CallPtr> open_;  // not answered yet, or not noticed yet that they are
    std::atomic<int> parsing_ = 0;
};

}  // namespace contactd::server
