// Runs the service in process, with messages as on the wire (docs/protocol.md) but without a socket.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "contactd/proto/frame.hpp"

namespace contactd::server {

/// Represents one request and the messages that answer it, for the requesting thread. Destroying it before the answer
/// cancels the request.
class Exchange {
   public:
    using Clock = std::chrono::steady_clock;
    using Message = proto::Frames;  ///< Holds the envelope and the array frames after it.

    virtual ~Exchange() = default;
    /// Returns the next message: progress, or the answer, which is the last one; nothing if `until` passes first. A
    /// request whose time has passed (timeout_ms) is answered with DEADLINE_EXCEEDED.
    virtual std::optional<Message> next(Clock::time_point until) = 0;
    /// Answers with CANCELLED and ends the work, unless there is an answer.
    virtual void cancel() = 0;
};

/// Can be used by any number of threads. Small solves run in the requesting thread, all others in the service's own
/// threads (configuration: workers), which start when they are first needed.
class InProcess {
   public:
    enum class Level { info, warning, error };
    using Log = std::function<void(Level, const std::string&)>;  ///< from any thread

    /// `config` is the JSON of a configuration. Throws Error if it is invalid, and StoreError.
    explicit InProcess(std::string_view config, Log log = {});
    /// Ends and frees nothing in a process forked from the creating one, because its threads do not exist there.
    ~InProcess();
    InProcess(const InProcess&) = delete;
    InProcess& operator=(const InProcess&) = delete;

    /// Starts a request. Errors of the message are answered as by a daemon. Throws Error if the service is closed, or
    /// belongs to another process.
    std::unique_ptr<Exchange> ask(const std::string& envelope, proto::Frames frames);
    /// Answers open requests with STOPPING, and returns when all work has ended. May be called twice.
    void close();

   private:
    struct State;
    const int owner_;  // the process
    std::shared_ptr<State> state_;
};

}  // namespace contactd::server
