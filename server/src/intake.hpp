// Turns messages into calls: access, parsing, and limits on open requests.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "access/rate_limit.hpp"
#include "config/config.hpp"
#include "engine/jobs/worker_pool.hpp"
#include "jobs/open_calls.hpp"
#include "service/service.hpp"
#include "wire/answering_socket.hpp"

namespace contactd::server {

/// The I/O thread reads small envelopes, and a separate thread large ones. In the I/O thread, other messages would wait
/// for them. A worker might not become free in time, while the deadline is still unknown.
class Intake {
   public:
    Intake(const Config& config, Service& service, AnsweringSocket& socket);

    /// Answers the message, or passes its call to the service. Call it in the I/O thread only.
    void take(Message message);
    /// Ends the separate thread and drops unread envelopes. Further messages can be handled afterwards.
    void stop();
    WorkerPool& reader() { return reader_; }

   private:
    using Clock = Call::Clock;

    bool admit(const Route& route, std::string_view envelope, Clock::time_point received);
    void read(Message message, Clock::time_point received, OpenCalls::Admission admission);
    void open(const Route& route, proto::Request request, Clock::time_point received, OpenCalls::Admission admission);

    const Config& config_;
    Service& service_;
    AnsweringSocket& socket_;
    OpenCalls& open_calls_;
    RateLimit rate_limit_;
    bool stopped_ = false;
    WorkerPool reader_{1};  // is destroyed first, because its thread uses everything above
};

}  // namespace contactd::server
