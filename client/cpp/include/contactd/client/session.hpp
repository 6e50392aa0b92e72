// Provides a session of the daemon: the steps of a simulation, each of which starts from the end of the previous one.
//
//     contactd::SessionSpec spec;
//     spec.setup = ...;                         // the set-up of all steps
//     spec.load.gap = ...;                      // and the default load of a step
//     contactd::client::Session session(client, spec);
//     contactd::StepInput input;
//     input.approach = 0.02;
//     std::cout << session.step(input).solution.forces.Fn << " N\n";
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "contactd/client/client.hpp"
#include "contactd/session.hpp"

namespace contactd::client {

/// Identifies a state that Session::save returns and Session::restore accepts.
struct SavedState {
    std::string name;
    long long step = 0;  ///< number of the last step when it was saved
};

class Session;
class WheelRailSession;

/// Describes a step of a session in a call with several sessions.
struct SessionStep {
    Session& session;
    StepInput input;
};
struct WheelRailSessionStep {
    WheelRailSession& session;
    WheelRailStepInput input;
};
using AnySessionStep = std::variant<SessionStep, WheelRailSessionStep>;

/// Solves the next step of each session in one message and on all workers of the daemon, for example all contacts of a
/// vehicle. The client of the first session sends the message, so call this from its thread. The other clients are not
/// used, but must belong to the same daemon and user. The answers have the order of the steps. A step that fails
/// leaves its session unchanged and does not affect the others. `input.again` repeats all steps, including those that
/// failed. Throws the exceptions of Session::step, and InvalidArgument for several daemons or users, or a repeated
/// session.
std::vector<StepOrStatus> step_many(std::span<const SessionStep> steps, const CallOptions& options = {});
/// Solves steps of contacts and of wheels on rails together, like step_many above.
std::vector<AnyStepOrStatus> step_many(std::span<const AnySessionStep> steps, const CallOptions& options = {});

/// Provides the common part of sessions of contacts and of wheels on rails.
///
/// Use it from the thread of its client and in the process that opened or joined it. Elsewhere, and during another of
/// its calls, a call throws ConcurrencyError. This class numbers the steps: a step whose answer did not arrive
/// (TimeoutError, ConnectionError) is requested again with the same number, and the daemon does not solve it twice. A
/// step that fails leaves the session unchanged. Every call throws the exceptions of Client.
class AnySession {
   public:
    AnySession(const AnySession&) = delete;
    AnySession& operator=(const AnySession&) = delete;

    /// Saves the state of the session.
    SavedState save(const CallOptions& options = {});
    /// Returns the session to a saved state, which is kept and can be restored again.
    void restore(const SavedState& state, const CallOptions& options = {});
    void forget(const SavedState& state, const CallOptions& options = {});
    /// Ends the session now. Throws StatusError (NOT_FOUND) if it has already ended.
    void close(const CallOptions& options = {});

    /// Returns the name of the session. Any client with the name can join and end the session.
    const std::string& name() const;
    /// Releases the session for other clients to join, and returns its name. This object no longer ends it.
    std::string release();

    long long step_number() const;  ///< number of the last step, 0 before the first
    double lease_seconds() const;   ///< idle time after which it ends
    std::size_t bytes() const;      ///< memory of the daemon when it was opened or joined

   protected:
    class Impl;
    explicit AnySession(std::unique_ptr<Impl> impl);
    /// Ends the session. If the daemon cannot be reached, the lease ends it.
    ~AnySession();
    Impl& impl() const { return *impl_; }

   private:
    friend std::vector<StepOrStatus> step_many(std::span<const SessionStep> steps, const CallOptions& options);
    friend std::vector<AnyStepOrStatus> step_many(std::span<const AnySessionStep> steps, const CallOptions& options);
    std::unique_ptr<Impl> impl_;
};

/// The session of a contact.
class Session : public AnySession {
   public:
    /// Opens a session. Returns when its tables are available, which may require a build. `client` must outlive the
    /// session. Also throws InvalidArgument for invalid input.
    Session(Client& client, const SessionSpec& spec, const CallOptions& options = {});
    /// Opens a session of a complete problem. Its gap, load and friction apply to the steps that omit them.
    Session(Client& client, const ContactProblem& problem, const CallOptions& options = {});
    /// Joins the session of this name in its current state; any client may have opened it. Clients that share a
    /// session must alternate and inform each other: the number of a step that another client has taken is refused
    /// (StatusError, FAILED_PRECONDITION) or, with the same inputs, receives the same answer. Throws StatusError
    /// (NOT_FOUND) if the session has ended, and InvalidArgument ("name") if it is of another kind.
    static Session join(Client& client, const std::string& name, const CallOptions& options = {});

    /// Solves the next step. Arrays of the solution are empty unless `input.fields` names them.
    StepReply step(const StepInput& input, const CallOptions& options = {});

    const IcUses& ics() const;  ///< origins of the influence coefficients

   private:
    explicit Session(std::unique_ptr<Impl> impl);
};

/// Represents the session of a wheel on its rail. Its profiles are sent and read once, and its operators are kept.
/// Steady rolling has no history: a step returns the result of Client::wheel_rail within the tolerances, but its
/// searches and solvers start from the previous step.
class WheelRailSession : public AnySession {
   public:
    /// Opens a session. `client` must outlive it. Also throws InvalidArgument naming the field, such as
    /// "wheelrail.setup.track.gauge".
    WheelRailSession(Client& client, const WheelRailSessionSpec& spec, const CallOptions& options = {});
    /// Joins a session of a wheel on its rail, like Session::join.
    static WheelRailSession join(Client& client, const std::string& name, const CallOptions& options = {});

    /// Solves the next step. Also throws InvalidArgument naming the field, such as "wheelrail.state.position.roll".
    WheelRailStepReply step(const WheelRailStepInput& input, const CallOptions& options = {});

   private:
    explicit WheelRailSession(std::unique_ptr<Impl> impl);
};

}  // namespace contactd::client
