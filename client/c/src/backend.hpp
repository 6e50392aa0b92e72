// Where contacts are solved: behind a daemon, or in process. What is above knows these classes only.
#pragma once

#include <chrono>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "contactd/session.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd::c {

/// The settings of a connection, which hold for contacts that are made later.
struct Settings {
    std::chrono::milliseconds connect_timeout{5'000}, timeout{60'000}, build_timeout{3'600'000};
    std::filesystem::path server_key{}, own_key{};
};

/// How one call may end, and whom it tells.
struct Control {
    std::optional<std::chrono::milliseconds> timeout{};  ///< instead of the settings'
    std::stop_token stop{};
    /// Receives the stage of the work and its fraction, 0..1, in the calling thread. May be empty.
    std::function<void(const std::string& stage, double fraction)> on_progress{};
};

/// A contact that was opened. One thread at a time; calls that fail leave it as it was. Calls throw InvalidArgument,
/// StatusError with the daemon's codes and reasons, and what failure.hpp knows beside.
class OpenContact {
   public:
    virtual ~OpenContact() = default;
    /// Arrays of the solution are empty unless `input.fields` names them.
    virtual StepReply step(const StepInput& input, const Control& control) = 0;
    /// Keeps where the contact is; the name of it.
    virtual std::string save(const Control& control) = 0;
    virtual void restore(const std::string& state, const Control& control) = 0;
    virtual void forget(const std::string& state, const Control& control) = 0;
    /// No other call follows.
    virtual void close(const Control& control) = 0;
    virtual const IcUses& ics() const = 0;
};

/// The inputs of a wheel on its rail, and the arrays that its patches shall have.
struct WheelInput {
    WheelRailSetup setup;
    WheelRailState state;
    SolutionFields fields;
    bool gap = false;
    bool again = false;  ///< from where the solve before started, which is taken back
};

/// The inputs of both wheels of a wheelset.
struct WheelsetInput {
    WheelsetSetup setup;
    WheelsetState state;
    SolutionFields fields;
    bool gap = false;
};

/// Where wheels on rails are solved. One thread at a time; a set-up that stays is kept, and a solve starts where the
/// one before ended: estimates, and of transient motions tractions.
class OpenWheel {
   public:
    virtual ~OpenWheel() = default;
    /// Tells if the next solve of such a set-up goes on from the one before, where there was one, and states stay.
    virtual bool goes_on_with(const WheelRailSetup& setup) const = 0;
    /// Arrays are empty unless they are asked for. Throws as OpenContact, naming "setup.track.gauge", ...
    virtual WheelRailSolution solve(const WheelInput& input, const Control& control) = 0;
    /// Keeps where the wheel is; the name of it. It is opened with the set-up first, where it is not.
    virtual std::string save(const WheelRailSetup& setup, const Control& control) = 0;
    virtual void restore(const std::string& state, const Control& control) = 0;
    virtual void forget(const std::string& state, const Control& control) = 0;
    /// Both wheels of a wheelset, from where the last such solve of the same set-up ended, within the tolerances: in
    /// process with its estimates, with a daemon at its height and roll.
    virtual WheelsetSolution solve_wheelset(const WheelsetInput& input, const Control& control) = 0;
};

/// A wheel's part of a call for several.
struct WheelCall {
    OpenWheel& wheel;
    const WheelInput& input;
    const Control& control;
};
/// The solution of a wheel, or what its solve has thrown.
using WheelResult = std::variant<WheelRailSolution, std::exception_ptr>;

/// Any number of threads at a time.
class Backend {
   public:
    virtual ~Backend() = default;
    /// Returns when the tables lie ready. `spec` has passed validate_opening.
    virtual std::unique_ptr<OpenContact> open(const SessionSpec& spec, const Settings& settings,
                                              const Control& control) const = 0;
    /// Returns the frames of so many strips of a section, each `ds` wide. Throws as strip_frames does, below
    /// "ics.section".
    virtual std::vector<StripFrame> frames(const Section& section, int columns, double ds, const Settings& settings,
                                           const Control& control) const = 0;
    /// Sends nothing yet.
    virtual std::unique_ptr<OpenWheel> open_wheel(const Settings& settings) const = 0;
    /// Solves wheels that were opened here by one user, each as its own solve does: in process on so many threads (0:
    /// as many as there are processors); with a daemon in one message, which ends for all when it ends for one. A wheel
    /// that fails does not keep the others from being solved.
    virtual std::vector<WheelResult> solve_many(std::span<const WheelCall> calls, int threads) const = 0;
    /// Throws when no contact can be solved there now.
    virtual void ping(const Settings& settings) const = 0;
};

/// The shortest table that comes with these columns, of whatever material.
inline IcSpec spec_of_frames(const Section& section, int columns, double ds) {
    IcSpec spec;
    spec.body = BodyShape::longitudinally_uniform;
    spec.section = section;
    spec.material = {1, 0.25};
    spec.dx = spec.dy = ds;
    spec.nx = 1;
    spec.ny = columns;
    return spec;
}

/// Returns the backend of a daemon at `endpoint`. Throws InvalidArgument ("where") for an invalid endpoint.
std::unique_ptr<Backend> make_remote_backend(const std::string& endpoint);

/// In process. Defined once for each library: libcontactd has none, and throws StatusError (UNIMPLEMENTED).
std::unique_ptr<Backend> make_local_backend();
bool has_local_backend();

}  // namespace contactd::c
