#include "call.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/proto/object.hpp"

namespace contactd::server {

using nlohmann::json;
using proto::Status;
using proto::StatusCode;

namespace {

json envelope(const json& id) {
    return proto::object({{"contactd", proto::protocol_version}, {"id", id}});
}

/// Returns the name of the client from its metadata.
std::string agent_of(const proto::Request& request) {
    const auto at = request.metadata.find("client");
    return at == request.metadata.end() ? std::string() : at->get<std::string>();
}

[[noreturn]] void too_large(const std::string& what, std::size_t is, std::size_t limit, const char* name) {
    throw proto::StatusError(StatusCode::invalid_argument, proto::reason::answer_too_large,
                             "The answer has " + std::to_string(is) + " " + what + ", but at most " +
                                 std::to_string(limit) + " are allowed (limits." + name +
                                 "). Request less at once, or arrays as frames.");
}

/// Rejects an answer that exceeds the client's limits.
void check_limits(const std::string& text, const proto::Frames& frames, const MessageLimits& limits) {
    std::size_t largest = text.size(), total = text.size();
    for (const auto& frame : frames) {
        largest = std::max(largest, frame.size());
        total += frame.size();
    }
    if (frames.size() + 1 > limits.max_frames) too_large("frames", frames.size() + 1, limits.max_frames, "max_frames");
    if (largest > limits.max_frame_bytes)
        too_large("bytes in one frame", largest, limits.max_frame_bytes, "max_frame_bytes");
    if (total > limits.max_message_bytes) too_large("bytes", total, limits.max_message_bytes, "max_message_bytes");
}

}  // namespace

bool Call::succeed(const json& result, proto::Frames frames) {
    return !answered_ && succeed_with(proto::dump(result), std::move(frames));
}

bool Call::succeed_with(std::string_view result, proto::Frames frames) {
    if (answered_) return false;
    json reply = envelope(request.id);
    reply["status"] = proto::to_json(Status{});
    std::string text = proto::dump(reply);
    text.pop_back();
    text.reserve(text.size() + result.size() + 16);
    text.append(",\"result\":").append(result).append("}");
    try {
        // The limits do not apply to information about the daemon itself.
        if (!request.method.starts_with("server.")) check_limits(text, frames, limits_);
    } catch (const proto::StatusError& error) {
        fail(error.status());
        return false;
    }
    return finish(Status{}, std::move(text), std::move(frames));
}

void Call::check_deadline() {
    if (answered_ || Clock::now() < deadline()) return;
    fail({StatusCode::deadline_exceeded,
          "The answer was not ready within " + std::to_string(request.timeout_ms) + " ms.",
          std::string(proto::reason::deadline_passed),
          {},
          0});
}

void Call::when_answered(std::function<void()> then) {
    {
        const std::scoped_lock lock(mutex_);
        if (!answered_) return then_.push_back(std::move(then));
    }
    then();
}

void Call::fail(const Status& status) {
    if (answered_) return;
    json reply = envelope(request.id);
    reply["status"] = proto::to_json(status);
    finish(status, proto::dump(reply), {});
}

bool Call::finish(const Status& status, std::string text, proto::Frames frames) {
    std::vector<std::function<void()>> then;
    {
        const std::scoped_lock lock(mutex_);
        if (answered_.exchange(true)) return false;
        then = std::exchange(then_, {});
    }
    for (const auto& step : then) step();
    const std::chrono::duration<double, std::milli> spent = Clock::now() - received;
    post_({route_, std::move(text), std::move(frames), false, request.id, request.method,
           std::string(proto::name_of(status.code)), spent.count(), status.reason, agent_of(request)});
    return true;
}

void Call::progress(const json& progress) {
    if (answered_ || route_.empty_delimiter) return;
    json message = envelope(request.id);
    message["progress"] = progress;
    post_({route_, proto::dump(message), {}, true, {}, {}, {}, 0, {}, {}});
}

void guarded(const CallPtr& call, const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& error) {
        call->fail(status_of(error));
    }
}

Answer refusal(Route route, const std::string& id, const Status& status) {
    json reply = envelope(id.empty() ? json(nullptr) : json(id));
    reply["status"] = proto::to_json(status);
    return {std::move(route),
            proto::dump(reply),
            {},
            false,
            id,
            "?",
            std::string(proto::name_of(status.code)),
            0,
            status.reason,
            {}};
}

}  // namespace contactd::server
