#include "contactd/client/session.hpp"

#include <utility>

#include "client_impl.hpp"

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

}  // namespace

Session::Session(Client& client, proto::SessionSpec spec, const CallOptions& options)
    : client_(client), spec_(std::move(spec)) {
    const ContactProblem& problem = spec_.problem;
    if (spec_.has_gap && spec_.has_load) validate(problem);
    const bool builds = problem.model == Model::full && !problem.given_ics && problem.ics.source == IcSource::fem;
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_session_spec(spec_, arrays);
    const ClientOptions& defaults = client_.impl_->options();
    const json result = client_.impl_
                            ->call("session.open", std::move(params), arrays.take_frames(), options,
                                   builds ? defaults.build_timeout : defaults.timeout)
                            .result;
    name_ = result["session"].get<std::string>();
    lease_seconds_ = result["lease_seconds"].get<double>();
    open_ = true;
}

Session::~Session() {
    if (!open_) return;
    try {
        close();
    } catch (const Error&) {  // its lease ends it
    }
}

json Session::ask(const char* method, const CallOptions& options, json more) {
    more["session"] = name_;
    return client_.impl_->quick(method, options, std::move(more));
}

proto::StepReply Session::step(const proto::StepInput& input, const CallOptions& options) {
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    const json params = proto::encode_step(name_, step_ + 1, input, spec_.problem.grid, arrays);
    const std::vector<std::string> frames = arrays.take_frames();
    const Reply reply = insist(
        [&] { return client_.impl_->call("session.step", params, frames, options, client_.impl_->options().timeout); });
    proto::StepReply step =
        decoded([&] { return proto::decode_step_reply(reply.result, reply.frames, spec_.problem.grid); });
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
    open_ = false;
    ask("session.close", options);
}

}  // namespace contactd::client
