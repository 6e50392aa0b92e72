#include "contactd/client/session.hpp"

#include <unistd.h>

#include <utility>

#include "client_impl.hpp"
#include "one_at_a_time.hpp"

namespace contactd::client {
namespace {

/// Once more when no answer came; the daemon knows a request that it has answered.
template <class Ask>
auto insist(const Ask& ask) {
    try {
        return ask();
    } catch (const TimeoutError&) {
        return ask();
    } catch (const ConnectionError&) {
        return ask();
    }
}

constexpr const char* in_use =
    "A call of this session runs, in another thread or in whose on_progress this is; a session takes one step at a "
    "time, "
    "in order. Open a session, and a client, for each thread.";

}  // namespace

Session::Session(Client& client, Grid grid, std::string name, double lease_seconds, long long step)
    : client_(client),
      grid_(grid),
      name_(std::move(name)),
      lease_seconds_(lease_seconds),
      step_(step),
      open_(!name_.empty()),
      process_(::getpid()) {}

Session::Session(Client& client, SessionSpec spec, const CallOptions& options)
    : Session(client, spec.setup.grid, {}, 0, 0) {
    validate_opening({spec.setup, spec.load});
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_session_spec(spec, arrays);
    const json result =
        client_.impl_->call("session.open", std::move(params), arrays.take_frames(), options, wait_of(spec.setup))
            .result;
    name_ = result["session"].get<std::string>();
    lease_seconds_ = result["lease_seconds"].get<double>();
    open_ = true;
}

Session::Session(Client& client, const ContactProblem& problem, const CallOptions& options)
    : Session(client, SessionSpec{problem, problem}, options) {}

Session Session::join(Client& client, const std::string& name, const CallOptions& options) {
    const json result = client.impl_->quick("session.info", options, {{"session", name}});
    const SessionInfo info = decoded([&] { return proto::decode_session_info(result); });
    return Session(client, info.grid, name, info.lease_seconds, info.step);
}

Session::~Session() {
    if (!open_ || process_ != ::getpid()) return;
    try {
        close();
    } catch (const Error&) {  // its lease ends it
    }
}

std::string Session::release() {
    check_process();
    open_ = false;
    return name_;
}

void Session::check_process() const {
    if (process_ == ::getpid()) return;
    throw ConcurrencyError("This session belongs to process " + std::to_string(process_) + ", from which process " +
                           std::to_string(::getpid()) +
                           " was forked; open one of your own, or take it over by Session::join(client, name).");
}

json Session::ask(const char* method, const CallOptions& options, json more) {
    check_process();
    const OneAtATime turn(user_, in_use);
    more["session"] = name_;
    return client_.impl_->quick(method, options, std::move(more));
}

StepReply Session::step(const StepInput& input, const CallOptions& options) {
    check_process();
    const OneAtATime turn(user_, in_use);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    const json params = proto::encode_step(name_, step_ + 1, input, grid_, arrays);
    const std::vector<std::string> frames = arrays.take_frames();
    const Reply reply = insist([&] { return client_.impl_->call("session.step", params, frames, options); });
    StepReply step = decoded([&] { return proto::decode_step_reply(reply.result, reply.frames, grid_); });
    step_ = step.step;
    return step;
}

SavedState Session::save(const CallOptions& options) {
    const json result = ask("session.save", options);
    return {result["state"].get<std::string>(), result["step"].get<long long>()};
}

void Session::restore(const SavedState& state, const CallOptions& options) {
    step_ = insist([&] { return ask("session.restore", options, {{"state", state.name}}); })["step"].get<long long>();
}

void Session::forget(const SavedState& state, const CallOptions& options) {
    ask("session.forget", options, {{"state", state.name}});
}

void Session::close(const CallOptions& options) {
    check_process();
    open_ = false;
    ask("session.close", options);
}

}  // namespace contactd::client
