// From messages to calls: who may ask, what they ask for, and who else waits.
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

/// Small envelopes are read by the I/O thread, large ones by a thread of its own: others would wait for the one, and
/// not in a worker, which may be long in coming while the deadline is not known yet.
class Intake {
   public:
    Intake(const Config& config, Service& service, AnsweringSocket& socket);

    /// Answers the message, or hands its call to the service. Of the I/O thread.
    void take(Message message);
    /// Ends the own thread; what it had not read is dropped. Messages can be taken afterwards.
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
    WorkerPool reader_{1};  // last: its thread uses everything above
};

}  // namespace contactd::server
