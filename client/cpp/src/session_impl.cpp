#include "session_impl.hpp"

#include <unistd.h>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "one_at_a_time.hpp"

namespace contactd::client {
namespace {

constexpr const char* in_use =
    "A call of this session is already running, in another thread or around this on_progress. A session takes one step "
    "at a time, in order. Open a session and a client for each thread.";

}  // namespace

AnySession::Impl::Impl(Client& client, std::optional<Grid> grid, SessionReply reply, long long step, Wait wait)
    : client_(client), grid_(grid), reply_(std::move(reply)), wait_(wait), step_(step), process_(::getpid()) {}

std::unique_ptr<AnySession::Impl> AnySession::Impl::opened(Client& client, const SessionSpec& spec,
                                                           const CallOptions& options) {
    validate_opening({spec.setup, spec.load});
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_session_spec(spec, arrays);
    const Reply reply =
        client.impl_->call("session.open", std::move(params), arrays.take_frames(), options, wait_of(spec.setup));
    return std::make_unique<Impl>(client, spec.setup.grid, proto::decode_session_reply(reply.result), 0);
}

std::unique_ptr<AnySession::Impl> AnySession::Impl::opened(Client& client, const WheelRailSessionSpec& spec,
                                                           const CallOptions& options) {
    validate_below("wheelrail.setup", spec.setup);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_session_spec(spec, arrays);
    const Reply reply = client.impl_->call("session.open", std::move(params), arrays.take_frames(), options);
    return std::make_unique<Impl>(client, std::nullopt, proto::decode_session_reply(reply.result), 0,
                                  wait_of(spec.setup));
}

std::unique_ptr<AnySession::Impl> AnySession::Impl::joined(Client& client, const std::string& name, Kind kind,
                                                           const CallOptions& options) {
    const json result = client.impl_->result_of("session.info", options, {{"session", name}});
    SessionInfo info = decoded([&] { return proto::decode_session_info(result); });
    if (info.grid.has_value() != (kind == Kind::contact))
        throw InvalidArgument("name", info.grid ? "belongs to the session of a contact; join it by Session::join"
                                                : "belongs to the session of a wheel on its rail; join it by "
                                                  "WheelRailSession::join");
    SessionReply reply{name, info.lease_seconds, info.bytes, std::move(info.ics)};
    return std::make_unique<Impl>(client, info.grid, std::move(reply), info.step);
}

bool AnySession::Impl::has_to_end() const {
    return open_ && process_ == ::getpid();
}

void AnySession::Impl::leave() {
    check_process();
    open_ = false;
}

void AnySession::Impl::check_process() const {
    if (process_ == ::getpid()) return;
    throw ConcurrencyError("This session belongs to process " + std::to_string(process_) + ", from which process " +
                           std::to_string(::getpid()) +
                           " was forked. Open a new session, or take it over with join(client, name).");
}

json AnySession::Impl::ask(const char* method, const CallOptions& options, json more) {
    check_process();
    const OneAtATime guard(user_, in_use);
    more["session"] = reply_.session;
    return client_.impl_->result_of(method, options, std::move(more));
}

long long AnySession::Impl::number_of(bool again) {
    if (!again || asked_ == 0) asked_ = step_ + 1;
    return asked_;
}

proto::StepAsked AnySession::Impl::asked(const Step& step) {
    if (const auto* wheel = std::get_if<const WheelRailStepInput*>(&step.input))
        validate_below("wheelrail.state", (*wheel)->state);
    const bool again = std::visit([](const auto* input) { return input->again; }, step.input);
    return {reply_.session, number_of(again), step.input, grid_};
}

void AnySession::Impl::note(const proto::StepAsked& asked, const AnyStepOrStatus& answer) {
    if (const auto* step = std::get_if<StepReply>(&answer)) step_ = step->step;
    if (const auto* step = std::get_if<WheelRailStepReply>(&answer)) {
        check_pressures(step->solution, std::get<const WheelRailStepInput*>(asked.input)->fields);
        step_ = step->step;
    }
}

AnyStepOrStatus AnySession::Impl::step(std::variant<const StepInput*, const WheelRailStepInput*> input,
                                       const CallOptions& options) {
    check_process();
    const OneAtATime guard(user_, in_use);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    const proto::StepAsked step = asked({*this, input});
    const json params = proto::encode_step(step, arrays);
    const proto::Frames frames = arrays.take_frames();
    const Answer reply =
        insist([&] { return client_.impl_->answer_to("session.step", params, frames, options, wait_); });
    AnyStepOrStatus answer = decoded([&] { return proto::decode_step_reply(reply.result, reply.frames, step); });
    note(step, answer);
    return answer;
}

std::vector<AnyStepOrStatus> AnySession::Impl::step_many(std::span<const Step> steps, const CallOptions& options) {
    Client& client = steps.front().session.client_;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::string field = "steps[" + std::to_string(i) + "].session";
        if (!client.impl_->speaks_for(*steps[i].session.client_.impl_))
            throw InvalidArgument(
                field, "belongs to a different daemon or user than steps[0].session; all must belong to one");
        for (std::size_t k = 0; k < i; ++k)
            if (steps[k].session.reply_.session == steps[i].session.reply_.session)
                throw InvalidArgument(
                    field, "is also that of steps[" + std::to_string(k) + "]; a session takes one step at a time");
    }
    std::vector<std::unique_ptr<const OneAtATime>> guards;
    for (const Step& step : steps) {
        step.session.check_process();
        guards.push_back(std::make_unique<const OneAtATime>(step.session.user_, in_use));
    }
    std::vector<proto::StepAsked> all;
    for (const Step& step : steps) all.push_back(step.session.asked(step));
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame, proto::EqualArrays::shared);
    const json params = proto::encode_steps(all, arrays);
    const proto::Frames frames = arrays.take_frames();
    const bool builds =
        std::ranges::any_of(steps, [](const Step& step) { return step.session.wait_ == Wait::for_build; });
    const Wait wait = builds ? Wait::for_build : Wait::for_answer;
    const Answer reply =
        insist([&] { return client.impl_->answer_to("session.step_many", params, frames, options, wait); });
    std::vector<AnyStepOrStatus> answers =
        decoded([&] { return proto::decode_step_replies(reply.result, reply.frames, all); });
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i].session.note(all[i], answers[i]);
    return answers;
}

}  // namespace contactd::client
