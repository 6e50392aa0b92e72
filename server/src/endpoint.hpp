// The ROUTER socket: the I/O thread takes requests in, answers go out.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>
#include <zmq.hpp>

#include "access/access_control.hpp"
#include "access/rate_limit.hpp"
#include "config/config.hpp"
#include "config/socket_file.hpp"
#include "jobs/call.hpp"
#include "operation/notify.hpp"
#include "operation/request_log.hpp"
#include "service.hpp"
#include "wire/client_connections.hpp"
#include "wire/connection_monitor.hpp"
#include "wire/mailbox.hpp"
#include "wire/open_calls.hpp"
#include "wire/outbox.hpp"
#include "wire/unfinished_input.hpp"

namespace contactd::server {

class Endpoint {
   public:
    /// Binds. Throws Error when the address cannot be used.
    Endpoint(const Config& config, Service& service);

    /// Where clients connect, with the port that was taken.
    std::string address() const;

    /// Serves until SIGTERM or SIGINT arrives at `signal_fd` (a signalfd). Then new requests are refused, those
    /// accepted have their time to be finished (shutdown.drain_seconds, or until the next such signal), and what is
    /// left is answered with STOPPING and ended. SIGHUP reads the allowed keys again, and calls `reload`.
    void run(int signal_fd, const Notifier& notifier, const std::function<void()>& reload);

   private:
    using SocketLock = std::unique_lock<std::mutex>;

    bool wait(SocketLock& lock, int signal_fd, long milliseconds);
    bool admit(const Route& route, std::string_view envelope, Call::Clock::time_point received);
    void reload_keys();
    void read_monitor();
    void drop_gone();
    bool receive();  ///< some of what has arrived; true when there is more
    void accept(Route route, std::string envelope, std::vector<std::string> frames);
    void parse_now(const Route& route, const std::string& envelope, std::vector<std::string> frames,
                   Call::Clock::time_point received, OpenCalls::Admission admission);
    void open_call(const Route& route, proto::Request request, Call::Clock::time_point received,
                   OpenCalls::Admission admission);
    void post(Answer answer);
    std::optional<RequestLine> send(Answer answer);
    void deliver();
    void end_overdue();
    long poll_milliseconds();
    void note_levels();
    void handle_signal(int signal, const Notifier& notifier, const std::function<void()>& reload);
    void begin_drain(const Notifier& notifier);
    bool is_draining() const { return end_ != Call::Clock::time_point::max(); }
    bool is_idle();
    void stop();

    const Config& config_;
    Service& service_;
    Mailbox<Answer> mailbox_;
    zmq::context_t context_;
    AccessControl access_;
    RateLimit rate_limit_;
    // Held by whoever uses the members from here to the next empty line: the I/O thread whenever it does not wait, and
    // for a moment a thread that has an answer.
    std::mutex socket_mutex_;
    zmq::socket_t socket_;
    std::optional<SocketFile> file_;  // ZeroMQ leaves it
    ConnectionMonitor monitor_;
    UnfinishedInput unfinished_;
    ClientConnections clients_;
    Outbox outbox_;
    Call::Clock::time_point end_ = Call::Clock::time_point::max();  // of the drain, once there is one
    Call::Clock::time_point sent_;                                  // when the last answer went out

    bool parser_ended_ = false;
    const std::thread::id thread_;
    WorkerPool parser_{1};  // last: its thread uses everything above
};

}  // namespace contactd::server
