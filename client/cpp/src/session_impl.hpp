// Implements sessions.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "client_impl.hpp"
#include "contactd/client/session.hpp"
#include "contactd/proto/session.hpp"

namespace contactd::client {

class AnySession::Impl {
   public:
    /// `grid` is that of a contact.
    Impl(Client& client, std::optional<Grid> grid, SessionReply reply, long long step, Wait wait = Wait::for_answer);

    static std::unique_ptr<Impl> opened(Client& client, const SessionSpec& spec, const CallOptions& options);
    static std::unique_ptr<Impl> opened(Client& client, const WheelRailSessionSpec& spec, const CallOptions& options);
    enum class Kind { contact, wheel_rail };
    static std::unique_ptr<Impl> joined(Client& client, const std::string& name, Kind kind, const CallOptions& options);

    bool has_to_end() const;
    /// Does not end it any more.
    void leave();

    json ask(const char* method, const CallOptions& options, json more = json::object());

    /// Solves a step of the session's kind. Throws StatusError if it fails.
    AnyStepOrStatus step(std::variant<const StepInput*, const WheelRailStepInput*> input, const CallOptions& options);
    struct Step {
        Impl& session;
        std::variant<const StepInput*, const WheelRailStepInput*> input;
    };
    /// Solves at least one step, with the client of the first; all have one daemon and one user.
    static std::vector<AnyStepOrStatus> step_many(std::span<const Step> steps, const CallOptions& options);
    void go_to(long long step) { step_ = asked_ = step; }

    const SessionReply& reply() const { return reply_; }
    long long step_number() const { return step_; }

   private:
    proto::StepAsked asked(const Step& step);
    /// Returns the number of the requested step.
    long long number_of(bool again);
    void check_process() const;
    /// Sets the state of the session from the answer.
    void note(const proto::StepAsked& asked, const AnyStepOrStatus& answer);

    Client& client_;
    const std::optional<Grid> grid_;
    const SessionReply reply_;
    const Wait wait_;  // of its steps
    long long step_;
    long long asked_ = step_;  // the last number requested
    bool open_ = true;
    const int process_;
    std::atomic<int> user_ = 0;
};

/// Repeats a request without an answer; the daemon recognises one that it has answered.
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

}  // namespace contactd::client
