// Implements contacts as sessions of a daemon. Each has its own connection, so that threads with different contacts do
// not wait for each other.
#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <stop_token>
#include <string_view>
#include <utility>

#include "backend.hpp"
#include "contactd/client/session.hpp"
#include "contactd/error.hpp"
#include "wheel_cache.hpp"

namespace contactd::c {
namespace {

client::ClientOptions options_of(const Settings& settings) {
    client::ClientOptions options;
    options.connect_timeout = settings.connect_timeout;
    options.timeout = settings.timeout;
    options.build_timeout = settings.build_timeout;
    options.server_key = settings.server_key;
    options.own_key = settings.own_key;
    options.on_warnings = [](const auto&) {};  // contacts and wheels report them to their logs
    return options;
}

client::CallOptions options_of(const Control& control) {
    client::CallOptions options;
    options.timeout = control.timeout;
    options.stop = control.stop;
    if (control.on_progress)
        options.on_progress = [&control](const client::Progress& progress) {
            control.on_progress(progress.stage, progress.fraction);
        };
    return options;
}

class RemoteContact final : public OpenContact {
   public:
    RemoteContact(const std::string& endpoint, const SessionSpec& spec, const Settings& settings,
                  const Control& control)
        : client_(endpoint, options_of(settings)), session_(client_, spec, options_of(control)) {}

    StepReply step(const StepInput& input, const Control& control) override {
        return session_.step(input, options_of(control));
    }
    std::string save(const Control& control) override { return session_.save(options_of(control)).name; }
    void restore(const std::string& state, const Control& control) override {
        session_.restore({state}, options_of(control));
    }
    void forget(const std::string& state, const Control& control) override {
        session_.forget({state}, options_of(control));
    }
    void close(const Control& control) override { session_.close(options_of(control)); }
    const IcUses& ics() const override { return session_.ics(); }

   private:
    client::Client client_;  // outlives the session
    client::Session session_;
};

/// Returns the result of `ask`; errors name fields as in the caller's inputs, which are not those of a session.
template <class Ask>
auto named_as_set(const Ask& ask) {
    constexpr std::string_view prefix = "wheelrail.";
    const auto without = [&](std::string text) { return text.starts_with(prefix) ? text.substr(prefix.size()) : text; };
    try {
        return ask();
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(without(error.field()), error.problem());
    } catch (const StatusError& error) {
        Status status = error.status();
        status.message = without(status.message);
        for (Violation& violation : status.violations) violation.field = without(violation.field);
        throw StatusError(std::move(status));
    }
}

class RemoteWheel final : public OpenWheel {
   public:
    RemoteWheel(const std::string& endpoint, const Settings& settings)
        : timeout_(settings.timeout), client_(endpoint, options_of(settings)) {}

    bool goes_on_with(const WheelRailSetup& setup) const override { return session_ && serves(opened_, setup); }
    WheelRailSolution solve(const WheelInput& input, const Control& control) override {
        const bool is_new = !goes_on_with(input.setup);
        const WheelRailStepInput request = named_as_set([&] { return request_of(input, control); });
        return end(input, control, is_new, [&] { return session_->step(request, options_of(control)).solution; });
    }
    /// Returns the part of this wheel in a step of several, after opening its session.
    client::WheelRailSessionStep begin(const WheelInput& input, const Control& control) {
        WheelRailStepInput request = named_as_set([&] { return request_of(input, control); });
        return {*session_, std::move(request)};
    }
    /// Returns the answer of `ask`, a step of this wheel. If its lease or its daemon has ended, steady rolling opens a
    /// new session, unless it was just opened.
    template <class Ask>
    WheelRailSolution end(const WheelInput& input, const Control& control, bool is_new, const Ask& ask) {
        try {
            return named_as_set(ask);
        } catch (const StatusError& error) {
            const bool may_reopen = input.state.motion == WheelRailMotion::steady_rolling && !is_new;
            if (!may_reopen || error.status().code != StatusCode::not_found) throw;
        }
        return named_as_set([&] {
            open(input.setup, control);
            return session_->step(request_of(input, control), options_of(control)).solution;
        });
    }
    std::chrono::milliseconds timeout(const Control& control) const { return control.timeout.value_or(timeout_); }
    std::string save(const WheelRailSetup& setup, const Control& control) override {
        if (!goes_on_with(setup)) named_as_set([&] { return open(setup, control), 0; });
        return session_->save(options_of(control)).name;
    }
    void restore(const std::string& state, const Control& control) override {
        session_->restore({state}, options_of(control));
    }
    void forget(const std::string& state, const Control& control) override {
        session_->forget({state}, options_of(control));
    }
    WheelsetSolution solve_wheelset(const WheelsetInput& input, const Control& control) override {
        WheelsetState state = input.state;
        if (wheelset_ && wheelset_->setup == input.setup) {
            state.position.z = wheelset_->z;
            state.position.roll = wheelset_->roll;
        }
        WheelsetSolution solution = client_.wheelset(input.setup, state, options_of(control), input.fields, input.gap);
        if (solution.converged()) wheelset_ = {input.setup, solution.right.z, solution.roll};
        return solution;
    }

   private:
    /// Opens a session if there is none for this set-up.
    WheelRailStepInput request_of(const WheelInput& input, const Control& control) {
        const bool goes_on = goes_on_with(input.setup);
        WheelRailStepInput request =
            step_of(goes_on ? opened_ : input.setup, input);  // refuses before anything is sent
        if (!goes_on) open(input.setup, control);
        request.again = input.again;
        return request;
    }
    /// The previous session ends after the next one is open, so that an opened wheel always has one.
    void open(const WheelRailSetup& setup, const Control& control) {
        session_ = std::make_unique<client::WheelRailSession>(client_, WheelRailSessionSpec{setup, {}, true},
                                                              options_of(control));
        opened_ = setup;
    }

    const std::chrono::milliseconds timeout_;
    client::Client client_;  // outlives the session
    std::unique_ptr<client::WheelRailSession> session_;
    WheelRailSetup opened_;  // the set-up of the session
    /// Stores height and roll at the end of the last search, where the next one starts.
    struct LastWheelset {
        WheelsetSetup setup;
        double z, roll;
    };
    std::optional<LastWheelset> wheelset_;
};

/// Sends the steps of several wheels as one message.
class RemoteWheels {
   public:
    explicit RemoteWheels(std::span<const WheelCall> calls) : results_(calls.size()) {
        std::vector<client::AnySessionStep> steps;
        std::vector<Part> parts;
        for (std::size_t i = 0; i < calls.size(); ++i)
            keep(i, [&] {
                RemoteWheel& wheel = static_cast<RemoteWheel&>(calls[i].wheel);
                const bool is_new = !wheel.goes_on_with(calls[i].input.setup);
                steps.emplace_back(wheel.begin(calls[i].input, calls[i].control));
                parts.push_back({i, wheel, calls[i], is_new});
            });
        if (parts.empty()) return;
        std::vector<AnyStepOrStatus> answers;
        std::exception_ptr failure;
        try {
            answers = client::step_many(steps, shared_options(parts));
        } catch (...) {
            failure = std::current_exception();
        }
        for (std::size_t k = 0; k < parts.size(); ++k)
            keep(parts[k].number, [&] {
                results_[parts[k].number] =
                    parts[k].wheel.end(parts[k].call.input, parts[k].call.control, parts[k].is_new, [&] {
                        if (failure) std::rethrow_exception(failure);
                        if (auto* status = std::get_if<Status>(&answers[k])) throw StatusError(std::move(*status));
                        return std::get<WheelRailStepReply>(std::move(answers[k])).solution;
                    });
            });
    }
    std::vector<WheelResult> results() && { return std::move(results_); }

   private:
    struct Part {
        std::size_t number;
        RemoteWheel& wheel;
        const WheelCall& call;
        bool is_new;
    };

    template <class Act>
    void keep(std::size_t number, const Act& act) {
        try {
            act();
        } catch (...) {
            results_[number] = std::current_exception();
        }
    }
    /// The first deadline or stop request ends all.
    client::CallOptions shared_options(std::span<const Part> parts) {
        client::CallOptions options;
        for (const Part& part : parts) {
            const auto timeout = part.wheel.timeout(part.call.control);
            options.timeout = options.timeout ? std::min(*options.timeout, timeout) : timeout;
            stops_.emplace_back(part.call.control.stop, [this] { stop_.request_stop(); });
        }
        options.stop = stop_.get_token();
        return options;
    }

    std::vector<WheelResult> results_;
    std::stop_source stop_;
    std::deque<std::stop_callback<std::function<void()>>> stops_;
};

class RemoteBackend final : public Backend {
   public:
    explicit RemoteBackend(std::string endpoint) : endpoint_(std::move(endpoint)) {}

    std::unique_ptr<OpenContact> open(const SessionSpec& spec, const Settings& settings,
                                      const Control& control) const override {
        return std::make_unique<RemoteContact>(endpoint_, spec, settings, control);
    }

    std::vector<StripFrame> frames(const Section& section, int columns, double ds, const Settings& settings,
                                   const Control& control) const override {
        const IcSpec spec = spec_of_frames(section, columns, ds);
        return client::Client(endpoint_, options_of(settings)).get_ic(spec, options_of(control)).frames;
    }

    std::unique_ptr<OpenWheel> open_wheel(const Settings& settings) const override {
        return std::make_unique<RemoteWheel>(endpoint_, settings);
    }

    std::vector<WheelResult> solve_many(std::span<const WheelCall> calls, int) const override {
        return RemoteWheels(calls).results();
    }

    void ping(const Settings& settings) const override {
        const std::string state = client::Client(endpoint_, options_of(settings)).health();
        if (state != "serving")
            throw StatusError(StatusCode::unavailable, reason::stopping,
                              "The daemon at " + endpoint_ + " is " + state + " and accepts no new requests.");
    }

   private:
    std::string endpoint_;
};

}  // namespace

std::unique_ptr<Backend> make_remote_backend(const std::string& endpoint) {
    try {
        if (!endpoint.starts_with("ipc://") && !endpoint.starts_with("tcp://")) throw Error("");
        client::Client{endpoint};  // sends nothing; reads the endpoint
    } catch (const Error&) {
        throw InvalidArgument("where", "is \"" + endpoint +
                                           "\"; it must be \"local\", or a daemon's endpoint such as ipc:///path or "
                                           "tcp://host:port");
    }
    return std::make_unique<RemoteBackend>(endpoint);
}

}  // namespace contactd::c
