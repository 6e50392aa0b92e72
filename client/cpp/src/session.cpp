#include "contactd/client/session.hpp"

#include <unistd.h>

#include <atomic>
#include <utility>

#include "client_impl.hpp"
#include "contactd/proto/session.hpp"
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
    "time, in order. Open a session, and a client, for each thread.";

}  // namespace

class Session::Impl {
   public:
    Impl(Client& client, const Grid& grid, SessionReply told, long long step)
        : client_(client), grid_(grid), told_(std::move(told)), step_(step), process_(::getpid()) {}

    static std::unique_ptr<Impl> opened(Client& client, const SessionSpec& spec, const CallOptions& options);
    static std::unique_ptr<Impl> joined(Client& client, const std::string& name, const CallOptions& options);

    bool has_to_end() const { return open_ && process_ == ::getpid(); }
    /// Ends it no more.
    void leave() {
        check_process();
        open_ = false;
    }

    json ask(const char* method, const CallOptions& options, json more = json::object()) {
        check_process();
        const OneAtATime turn(user_, in_use);
        more["session"] = told_.session;
        return client_.impl_->quick(method, options, std::move(more));
    }

    StepReply step(const StepInput& input, const CallOptions& options);
    static std::vector<StepOrStatus> step_many(std::span<const SessionStep> steps, const CallOptions& options);
    void go_to(long long step) { step_ = asked_ = step; }

    const SessionReply& told() const { return told_; }
    long long step_number() const { return step_; }

   private:
    /// The number of what `input` says.
    long long number_of(const StepInput& input) {
        if (!input.again || asked_ == 0) asked_ = step_ + 1;
        return asked_;
    }
    void check_process() const {
        if (process_ == ::getpid()) return;
        throw ConcurrencyError("This session belongs to process " + std::to_string(process_) + ", from which process " +
                               std::to_string(::getpid()) +
                               " was forked; open one of your own, or take it over by Session::join(client, name).");
    }

    Client& client_;
    const Grid grid_;
    const SessionReply told_;
    long long step_;
    long long asked_ = step_;  // the number that was asked for last
    bool open_ = true;
    const int process_;
    std::atomic<int> user_ = 0;
};

std::unique_ptr<Session::Impl> Session::Impl::opened(Client& client, const SessionSpec& spec,
                                                     const CallOptions& options) {
    validate_opening({spec.setup, spec.load});
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_session_spec(spec, arrays);
    const Reply reply =
        client.impl_->call("session.open", std::move(params), arrays.take_frames(), options, wait_of(spec.setup));
    return std::make_unique<Impl>(client, spec.setup.grid, proto::decode_session_reply(reply.result), 0);
}

std::unique_ptr<Session::Impl> Session::Impl::joined(Client& client, const std::string& name,
                                                     const CallOptions& options) {
    const json result = client.impl_->quick("session.info", options, {{"session", name}});
    SessionInfo info = decoded([&] { return proto::decode_session_info(result); });
    SessionReply told{name, info.lease_seconds, info.bytes, std::move(info.ics)};
    return std::make_unique<Impl>(client, info.grid, std::move(told), info.step);
}

StepReply Session::Impl::step(const StepInput& input, const CallOptions& options) {
    check_process();
    const OneAtATime turn(user_, in_use);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    const json params = proto::encode_step(told_.session, number_of(input), input, grid_, arrays);
    const std::vector<std::string> frames = arrays.take_frames();
    const Reply reply = insist([&] { return client_.impl_->call("session.step", params, frames, options); });
    StepReply step = decoded([&] { return proto::decode_step_reply(reply.result, reply.frames, grid_); });
    step_ = step.step;
    return step;
}

std::vector<StepOrStatus> Session::Impl::step_many(std::span<const SessionStep> steps, const CallOptions& options) {
    Client& client = steps.front().session.impl_->client_;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const std::string field = "steps[" + std::to_string(i) + "].session";
        if (&steps[i].session.impl_->client_ != &client)
            throw InvalidArgument(field, "is of another client than steps[0].session; all must be of one");
        for (std::size_t k = 0; k < i; ++k)
            if (steps[k].session.name() == steps[i].session.name())
                throw InvalidArgument(field,
                                      "is that of steps[" + std::to_string(k) + "]; each takes one step at a time");
    }
    std::vector<std::unique_ptr<const OneAtATime>> turns;
    for (const SessionStep& step : steps) {
        step.session.impl_->check_process();
        turns.push_back(std::make_unique<const OneAtATime>(step.session.impl_->user_, in_use));
    }
    std::vector<proto::StepAsked> asked;
    std::vector<Grid> grids;
    for (const SessionStep& step : steps) {
        Impl& session = *step.session.impl_;
        asked.push_back({session.told_.session, session.number_of(step.input), step.input, session.grid_});
        grids.push_back(session.grid_);
    }
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame, proto::EqualArrays::shared);
    const json params = proto::encode_steps(asked, arrays);
    const std::vector<std::string> frames = arrays.take_frames();
    const Reply reply = insist([&] { return client.impl_->call("session.step_many", params, frames, options); });
    std::vector<StepOrStatus> replies =
        decoded([&] { return proto::decode_step_replies(reply.result, reply.frames, grids); });
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (const auto* step = std::get_if<StepReply>(&replies[i])) steps[i].session.impl_->step_ = step->step;
    return replies;
}

std::vector<StepOrStatus> step_many(std::span<const SessionStep> steps, const CallOptions& options) {
    if (steps.empty()) return {};
    return Session::Impl::step_many(steps, options);
}

Session::Session(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Session::Session(Client& client, const SessionSpec& spec, const CallOptions& options)
    : Session(Impl::opened(client, spec, options)) {}

Session::Session(Client& client, const ContactProblem& problem, const CallOptions& options)
    : Session(client, SessionSpec{problem, problem}, options) {}

Session Session::join(Client& client, const std::string& name, const CallOptions& options) {
    return Session(Impl::joined(client, name, options));
}

Session::~Session() {
    if (!impl_->has_to_end()) return;
    try {
        close();
    } catch (const Error&) {  // its lease ends it
    }
}

StepReply Session::step(const StepInput& input, const CallOptions& options) {
    return impl_->step(input, options);
}

SavedState Session::save(const CallOptions& options) {
    const json result = impl_->ask("session.save", options);
    return {result["state"].get<std::string>(), result["step"].get<long long>()};
}

void Session::restore(const SavedState& state, const CallOptions& options) {
    const json result = insist([&] { return impl_->ask("session.restore", options, {{"state", state.name}}); });
    impl_->go_to(result["step"].get<long long>());
}

void Session::forget(const SavedState& state, const CallOptions& options) {
    impl_->ask("session.forget", options, {{"state", state.name}});
}

void Session::close(const CallOptions& options) {
    impl_->leave();
    impl_->ask("session.close", options);
}

const std::string& Session::name() const {
    return impl_->told().session;
}

std::string Session::release() {
    impl_->leave();
    return name();
}

long long Session::step_number() const {
    return impl_->step_number();
}

double Session::lease_seconds() const {
    return impl_->told().lease_seconds;
}

std::size_t Session::bytes() const {
    return impl_->told().bytes;
}

const IcUses& Session::ics() const {
    return impl_->told().ics;
}

}  // namespace contactd::client
