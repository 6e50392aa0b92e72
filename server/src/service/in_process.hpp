// The service in process: messages as on the wire (docs/protocol.md), and no socket that they come through.
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

/// One request and the messages that answer it. For the thread that asked. Who lets go of it before it is answered
/// cancels it.
class Exchange {
   public:
    using Clock = std::chrono::steady_clock;
    using Message = proto::Frames;  ///< the envelope, and the array frames behind it

    virtual ~Exchange() = default;
    /// The next message: progress, or the answer, which is the last one. None when `until` comes first. A request whose
    /// time is up (timeout_ms) is answered with DEADLINE_EXCEEDED.
    virtual std::optional<Message> next(Clock::time_point until) = 0;
    /// Answers with CANCELLED, and ends the work, unless there is an answer.
    virtual void cancel() = 0;
};

/// Any number of threads at a time. Small solves are done in the thread that asks, all others by threads of its own
/// (configuration: workers), which start when they are first needed.
class InProcess {
   public:
    enum class Level { info, warning, error };
    using Log = std::function<void(Level, const std::string&)>;  ///< from any thread

    /// `config` is the JSON of a configuration. Throws Error when it cannot be used, and StoreError.
    explicit InProcess(std::string_view config, Log log = {});
    /// In a process that was forked from the one that made it, nothing is ended or freed: its threads are not there.
    ~InProcess();
    InProcess(const InProcess&) = delete;
    InProcess& operator=(const InProcess&) = delete;

    /// Whatever is wrong with the message is answered as the daemon would. Throws Error when the service is closed, or
    /// of another process.
    std::unique_ptr<Exchange> ask(const std::string& envelope, proto::Frames frames);
    /// Answers what is open with STOPPING, and returns when all work has ended. May be called twice.
    void close();

   private:
    struct State;
    const int owner_;  // the process
    std::shared_ptr<State> state_;
};

}  // namespace contactd::server
