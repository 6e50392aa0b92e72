// Represents one request being processed by the daemon.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "contactd/proto/message.hpp"
#include "contactd/proto/status.hpp"
#include "engine/jobs/job.hpp"
#include "engine/jobs/worker_pool.hpp"

namespace contactd::server {

using engine::Job;
using engine::QueueTicket;
using engine::WorkerPool;

/// Holds the route of an answer to its client.
struct Route {
    std::string identity;          ///< identity of the client, given by ROUTER
    bool empty_delimiter = false;  ///< true for a REQ socket: one answer only, after an empty frame
    std::string user{};            ///< the sender of the request (AccessControl); empty when its key was revoked
};

/// Numbers an open request; 0 for one that is answered immediately.
using CallNumber = std::uint64_t;

/// Holds an outgoing answer: frame 0 and its arrays.
struct Answer {
    Route route;
    std::string envelope;
    proto::Frames frames;
    bool is_progress = false;
    // These members are for the log and the metrics, except for progress.
    std::string id, method, status;
    double milliseconds = 0;
    std::string reason;  ///< empty when the status is OK
    std::string agent;   ///< name that the client gives itself
    CallNumber number = 0;
    std::shared_ptr<const void> counted{};  ///< counts its bytes until the last of its frames has been sent
};

/// Answers once, from any thread; later answers are dropped.
class Call {
   public:
    using Clock = std::chrono::steady_clock;
    using Post = std::function<void(Answer)>;  ///< to the I/O thread

    Call(Route route, proto::Request parsed, Clock::time_point received_at, proto::Priority its_priority,
         const MessageLimits& limits, Post post)
        : request(std::move(parsed)),
          received(received_at),
          priority(its_priority),
          route_(std::move(route)),
          limits_(limits),
          post_(std::move(post)) {}

    const proto::Request request;
    const Clock::time_point received;
    const proto::Priority priority;
    /// Holds the work that answers it, if job.list shows it; set by job_of.
    std::shared_ptr<Job> job;
    /// True if its expected work is long, so that it must leave a worker to others. Set before the work is queued.
    bool is_large = false;
    /// Holds the bytes of the running work, released when they are reset (WorkBudget).
    std::shared_ptr<const void> work;

    /// Returns the connection of the request, by which queues and limits count clients.
    const std::string& client() const { return route_.identity; }
    const std::string& user() const { return route_.user; }

    /// Returns the client's deadline, or never.
    Clock::time_point deadline() const {
        return request.timeout_ms > 0 ? received + std::chrono::milliseconds(request.timeout_ms)
                                      : Clock::time_point::max();
    }
    bool answered() const { return answered_; }
    /// Lets the work continue from now on, for repeated requests, even if its client disconnects.
    void outlive_client() { outlives_client_ = true; }
    bool outlives_client() const { return outlives_client_; }
    /// Answers DEADLINE_EXCEEDED if the deadline has passed.
    void check_deadline();
    /// Calls the function with the answer, or now if there is one. The function must not hold this call.
    void when_answered(std::function<void()> then);
    /// Answers with the result, or with ANSWER_TOO_LARGE if it exceeds the limits of a message. Returns whether the
    /// result was the answer.
    bool succeed(const nlohmann::json& result, proto::Frames frames = {});
    /// Answers with the JSON text of a result.
    bool succeed_with(std::string_view result, proto::Frames frames);
    void fail(const proto::Status& status);
    void progress(const nlohmann::json& progress);

   private:
    bool finish(const proto::Status& status, std::string text, proto::Frames frames);

    const Route route_;
    const MessageLimits& limits_;
    const Post post_;
    std::atomic<bool> answered_ = false;
    std::atomic<bool> outlives_client_ = false;
    std::mutex mutex_;
    std::vector<std::function<void()>> then_;
};

using CallPtr = std::shared_ptr<Call>;

/// Returns the ticket for work of `call` in a pool; work of an answered call is dropped.
inline QueueTicket ticket_of(const CallPtr& call) {
    return {call->client(), call->priority, [call] { return call->answered(); }, call->user(), call->is_large};
}

/// Returns the reply to a request with an unreadable envelope; `id` is empty if it is unknown.
Answer refusal(Route route, const std::string& id, const proto::Status& status);

/// Runs `work`. An exception becomes the answer of the call.
void guarded(const CallPtr& call, const std::function<void()>& work);

}  // namespace contactd::server
