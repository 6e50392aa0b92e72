// Runs the I/O thread, which waits for messages, answers and signals, and handles them.
#pragma once

#include <functional>
#include <string>
#include <zmq.hpp>

#include "access/access_control.hpp"
#include "config/config.hpp"
#include "intake.hpp"
#include "jobs/call.hpp"
#include "operation/memory_return.hpp"
#include "operation/notify.hpp"
#include "service/service.hpp"
#include "wire/answering_socket.hpp"
#include "wire/connection_monitor.hpp"

namespace contactd::server {

/// Belongs to the thread that creates it, like its socket.
class Endpoint {
   public:
    /// Binds the socket. Throws Error if the address cannot be used.
    Endpoint(const Config& config, Service& service);

    /// Returns the address that clients connect to, with the actual port.
    std::string address() const { return socket_.address(); }

    /// Serves until SIGTERM or SIGINT arrives at `signal_fd` (a signalfd). Then new requests are refused, and accepted
    /// ones may finish for shutdown.drain_seconds, or until the next such signal. The remaining ones are answered with
    /// STOPPING and ended. SIGHUP reads the allowed keys again, and calls `reload`.
    void run(int signal_fd, const Notifier& notifier, const std::function<void()>& reload);

   private:
    using Clock = Call::Clock;

    bool wait(int signal_fd, const Notifier& notifier);
    bool receive();  ///< Reads some of the arrived messages; returns true if there are more.
    void end_overdue();
    void end_gone();
    void end_revoked();
    void note_levels();
    void handle_signal(int signal, const Notifier& notifier, const std::function<void()>& reload);
    void begin_drain(const Notifier& notifier);
    bool is_draining() const { return end_ != Clock::time_point::max(); }
    bool is_idle();
    void stop();

    const Config& config_;
    Service& service_;
    const DaemonParts& parts_;
    zmq::context_t context_;
    AccessControl access_;
    AnsweringSocket socket_;
    ConnectionMonitor connections_;
    Clock::time_point end_ = Clock::time_point::max();     // end of the drain, once it has begun
    Clock::time_point unused_ = Clock::time_point::max();  // time at which operators beyond their budget may be freed
    MemoryReturn memory_;
    Intake intake_;  // is destroyed first, because its thread uses the socket
};

}  // namespace contactd::server
