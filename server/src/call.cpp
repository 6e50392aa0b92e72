#include "call.hpp"

#include <new>

#include "contactd/error.hpp"

namespace contactd::server {

using nlohmann::json;
using proto::Status;
using proto::StatusCode;

namespace {

json envelope(const json& id) {
    return {{"contactd", proto::protocol_version}, {"id", id}};
}

}  // namespace

void Call::succeed(const json& result, std::vector<std::string> frames) {
    finish(Status{}, &result, std::move(frames));
}

void Call::fail(const Status& status) {
    finish(status, nullptr, {});
}

void Call::finish(const Status& status, const json* result, std::vector<std::string> frames) {
    if (answered_.exchange(true)) return;
    json reply = envelope(request.id);
    reply["status"] = proto::to_json(status);
    std::string text = proto::dump(reply);
    if (result) text.replace(text.size() - 1, 1, ",\"result\":" + proto::dump(*result) + "}");  // without a copy of it
    const std::chrono::duration<double, std::milli> spent = Clock::now() - received;
    post_({route_, std::move(text), std::move(frames), false, request.id, request.method,
           std::string(proto::name_of(status.code)), spent.count(), status.reason});
}

void Call::progress(const json& progress) {
    if (answered_ || route_.empty_delimiter) return;
    json message = envelope(request.id);
    message["progress"] = progress;
    post_({route_, proto::dump(message), {}, true, {}, {}, {}, 0, {}});
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
    return {std::move(route), proto::dump(reply), {}, false, id, "?", std::string(proto::name_of(status.code)), 0,
            status.reason};
}

Status status_of(const std::exception& error) {
    if (const auto* known = dynamic_cast<const proto::StatusError*>(&error)) return known->status();
    if (const auto* invalid = dynamic_cast<const InvalidArgument*>(&error)) {
        const std::string problem = std::string(error.what()).substr(invalid->field().size() + 1);
        return proto::invalid_field(invalid->field(), problem).status();
    }
    if (dynamic_cast<const Cancelled*>(&error))
        return {StatusCode::cancelled, error.what(), std::string(proto::reason::job_cancelled), {}, 0};
    if (dynamic_cast<const std::bad_alloc*>(&error))
        return {StatusCode::resource_exhausted,
                "There is not enough memory for this request.",
                std::string(proto::reason::limit_exceeded),
                {},
                0};
    return {StatusCode::internal, error.what(), std::string(proto::reason::unexpected), {}, 0};
}

}  // namespace contactd::server
