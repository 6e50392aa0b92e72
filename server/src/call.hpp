// One request on its way through the daemon.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contactd/proto/message.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::server {

/// Where the answer goes.
struct Route {
    std::string identity;          ///< of the client, given by ROUTER
    bool empty_delimiter = false;  ///< a REQ socket: one answer only, behind an empty frame
};

/// What goes out: frame 0 and the arrays behind it.
struct Answer {
    Route route;
    std::string envelope;
    std::vector<std::string> frames;
    bool is_progress = false;
    // For the log and the metrics, when it is no progress:
    std::string id, method, status;
    double milliseconds = 0;
    std::string reason;  ///< empty when the status is OK
};

/// Answers once, from any thread; what comes after the first answer is dropped.
class Call {
   public:
    using Clock = std::chrono::steady_clock;
    using Post = std::function<void(Answer)>;  ///< to the I/O thread

    Call(Route route, proto::Request parsed, Clock::time_point received_at, Post post)
        : request(std::move(parsed)), received(received_at), route_(std::move(route)), post_(std::move(post)) {}

    const proto::Request request;
    const Clock::time_point received;

    /// The deadline the client gave, or never.
    Clock::time_point deadline() const {
        return request.timeout_ms > 0 ? received + std::chrono::milliseconds(request.timeout_ms)
                                      : Clock::time_point::max();
    }
    bool answered() const { return answered_; }
    void succeed(const nlohmann::json& result, std::vector<std::string> frames = {});
    void fail(const proto::Status& status);
    void progress(const nlohmann::json& progress);

   private:
    void finish(const proto::Status& status, const nlohmann::json* result, std::vector<std::string> frames);

    const Route route_;
    const Post post_;
    std::atomic<bool> answered_ = false;
};

using CallPtr = std::shared_ptr<Call>;

/// The reply to a request whose envelope could not be read; `id` is empty when it is not known.
Answer refusal(Route route, const std::string& id, const proto::Status& status);

/// Runs `work`; what it throws becomes the answer of the call.
void guarded(const CallPtr& call, const std::function<void()>& work);

/// What a thrown exception means on the wire.
proto::Status status_of(const std::exception& error);

}  // namespace contactd::server
