#include "contactd/client/session.hpp"

#include <utility>

#include "session_impl.hpp"

namespace contactd::client {

std::vector<StepOrStatus> step_many(std::span<const SessionStep> steps, const CallOptions& options) {
    if (steps.empty()) return {};
    std::vector<AnySession::Impl::Step> all;
    for (const auto& [session, input] : steps) all.push_back({static_cast<AnySession&>(session).impl(), &input});
    std::vector<StepOrStatus> answers;
    for (AnyStepOrStatus& answer : AnySession::Impl::step_many(all, options)) {
        if (auto* step = std::get_if<StepReply>(&answer))
            answers.emplace_back(std::move(*step));
        else
            answers.emplace_back(std::get<Status>(std::move(answer)));
    }
    return answers;
}

std::vector<AnyStepOrStatus> step_many(std::span<const AnySessionStep> steps, const CallOptions& options) {
    if (steps.empty()) return {};
    std::vector<AnySession::Impl::Step> all;
    for (const AnySessionStep& step : steps)
        std::visit([&](const auto& of) { all.push_back({static_cast<AnySession&>(of.session).impl(), &of.input}); },
                   step);
    return AnySession::Impl::step_many(all, options);
}

AnySession::AnySession(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

AnySession::~AnySession() {
    if (!impl_->has_to_end()) return;
    try {
        close();
    } catch (const Error&) {  // its lease ends it
    }
}

SavedState AnySession::save(const CallOptions& options) {
    const json result = impl_->ask("session.save", options);
    return {result["state"].get<std::string>(), result["step"].get<long long>()};
}

void AnySession::restore(const SavedState& state, const CallOptions& options) {
    const json result = insist([&] { return impl_->ask("session.restore", options, {{"state", state.name}}); });
    impl_->go_to(result["step"].get<long long>());
}

void AnySession::forget(const SavedState& state, const CallOptions& options) {
    impl_->ask("session.forget", options, {{"state", state.name}});
}

void AnySession::close(const CallOptions& options) {
    impl_->leave();
    impl_->ask("session.close", options);
}

const std::string& AnySession::name() const {
    return impl_->reply().session;
}

std::string AnySession::release() {
    impl_->leave();
    return name();
}

long long AnySession::step_number() const {
    return impl_->step_number();
}

double AnySession::lease_seconds() const {
    return impl_->reply().lease_seconds;
}

std::size_t AnySession::bytes() const {
    return impl_->reply().bytes;
}

Session::Session(std::unique_ptr<Impl> impl) : AnySession(std::move(impl)) {}

Session::Session(Client& client, const SessionSpec& spec, const CallOptions& options)
    : AnySession(Impl::opened(client, spec, options)) {}

Session::Session(Client& client, const ContactProblem& problem, const CallOptions& options)
    : Session(client, SessionSpec{problem, problem}, options) {}

Session Session::join(Client& client, const std::string& name, const CallOptions& options) {
    return Session(Impl::joined(client, name, Impl::Kind::contact, options));
}

StepReply Session::step(const StepInput& input, const CallOptions& options) {
    return std::get<StepReply>(impl().step(&input, options));
}

const IcUses& Session::ics() const {
    return impl().reply().ics;
}

WheelRailSession::WheelRailSession(std::unique_ptr<Impl> impl) : AnySession(std::move(impl)) {}

WheelRailSession::WheelRailSession(Client& client, const WheelRailSessionSpec& spec, const CallOptions& options)
    : AnySession(Impl::opened(client, spec, options)) {}

WheelRailSession WheelRailSession::join(Client& client, const std::string& name, const CallOptions& options) {
    return WheelRailSession(Impl::joined(client, name, Impl::Kind::wheel_rail, options));
}

WheelRailStepReply WheelRailSession::step(const WheelRailStepInput& input, const CallOptions& options) {
    return std::get<WheelRailStepReply>(impl().step(&input, options));
}

}  // namespace contactd::client
