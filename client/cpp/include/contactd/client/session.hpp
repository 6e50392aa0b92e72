// A session of the daemon: the steps of a simulation, each of which starts where the one before ended.
//
//     contactd::SessionSpec spec;
//     spec.setup = ...;                         // what all steps have in common
//     spec.load.gap = ...;                      // and what holds for those that do not say it
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

/// A state that Session::save returns and Session::restore takes.
struct SavedState {
    std::string name;
    long long step = 0;  ///< number of the last step when it was saved
};

class Session;
class WheelRailSession;

/// A step of one of several sessions.
struct SessionStep {
    Session& session;
    StepInput input;
};
struct WheelRailSessionStep {
    WheelRailSession& session;
    WheelRailStepInput input;
};
using AnySessionStep = std::variant<SessionStep, WheelRailSessionStep>;

/// Solves the next step of each session in one message and on all workers of the daemon: the contacts of a vehicle. The
/// client of the first session sends it, whose thread this is; clients of the others need only be of the same daemon
/// and user, and are not used. The answers have the order of the steps; one that fails leaves its session as it was and
/// does not fail the others. With `input.again` all are tried anew, those that failed too. Throws what Session::step
/// does, and InvalidArgument when sessions are of several daemons or users, or one stands twice.
std::vector<StepOrStatus> step_many(std::span<const SessionStep> steps, const CallOptions& options = {});
/// Takes steps of contacts and of wheels on rails together, as step_many above does.
std::vector<AnyStepOrStatus> step_many(std::span<const AnySessionStep> steps, const CallOptions& options = {});

/// The common part of sessions of contacts and of wheels on rails.
///
/// Belongs to the thread of its client, and to the process that opened or joined it: elsewhere, and while another of
/// its calls runs, a call throws ConcurrencyError. Steps are numbered here: one whose answer does not come
/// (TimeoutError, ConnectionError) is asked for once more under its number, which the daemon answers without solving
/// twice. A step that fails leaves the session as it was. Every call throws what Client's do.
class AnySession {
   public:
    AnySession(const AnySession&) = delete;
    AnySession& operator=(const AnySession&) = delete;

    /// Saves the state of the session.
    SavedState save(const CallOptions& options = {});
    /// Takes the session to a saved state, which stays and can be restored again.
    void restore(const SavedState& state, const CallOptions& options = {});
    void forget(const SavedState& state, const CallOptions& options = {});
    /// Ends the session now, and says so when it has ended already (StatusError, NOT_FOUND).
    void close(const CallOptions& options = {});

    /// The key to the session: who has it can join it, and end it.
    const std::string& name() const;
    /// Leaves the session to whoever joins it: neither this object's end nor anything else here ends it any more.
    std::string release();

    long long step_number() const;  ///< of the last step, 0 before the first
    double lease_seconds() const;   ///< it ends when unused for that long
    std::size_t bytes() const;      ///< of the daemon's memory, when it was opened or joined

   protected:
    class Impl;
    explicit AnySession(std::unique_ptr<Impl> impl);
    /// Ends the session; should the daemon be out of reach, its lease does.
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
    /// Opens a session; returns when the tables lie ready, which may take a build. `client` outlives it. Throws
    /// InvalidArgument too, for a problem that cannot be solved as stated.
    Session(Client& client, const SessionSpec& spec, const CallOptions& options = {});
    /// Opens a session of a complete problem: its gap, load and friction hold for the steps that name none.
    Session(Client& client, const ContactProblem& problem, const CallOptions& options = {});
    /// The session of this name, where its last step left it, whoever opened it and wherever. Two who share a session
    /// alternate, and inform each other: the number of a step that the other one has taken is refused (StatusError,
    /// FAILED_PRECONDITION) or, asked for with the same inputs, answered as the other one was. Throws StatusError
    /// (NOT_FOUND) when it has ended, and InvalidArgument ("name") when it is of another kind.
    static Session join(Client& client, const std::string& name, const CallOptions& options = {});

    /// Solves the next step. Arrays of the solution are empty unless `input.fields` names them.
    StepReply step(const StepInput& input, const CallOptions& options = {});

    const IcUses& ics() const;  ///< where the influence coefficients came from

   private:
    explicit Session(std::unique_ptr<Impl> impl);
};

/// The session of a wheel on its rail: its profiles are sent and read once, and its operators are kept. Steady rolling
/// knows no history: a step answers what Client::wheel_rail does, within the tolerances, and starts its searches and
/// solvers from the step before.
class WheelRailSession : public AnySession {
   public:
    /// Opens a session. `client` outlives it. Throws InvalidArgument too, naming "wheelrail.setup.track.gauge", ...
    WheelRailSession(Client& client, const WheelRailSessionSpec& spec, const CallOptions& options = {});
    /// Joins a session of a wheel on its rail, as Session::join does.
    static WheelRailSession join(Client& client, const std::string& name, const CallOptions& options = {});

    /// Solves the next step. Throws InvalidArgument naming "wheelrail.state.position.roll", ...
    WheelRailStepReply step(const WheelRailStepInput& input, const CallOptions& options = {});

   private:
    explicit WheelRailSession(std::unique_ptr<Impl> impl);
};

}  // namespace contactd::client
