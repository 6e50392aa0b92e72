// Declares the interface to solvers of contacts: a daemon, or the engine in process.
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

/// Holds the settings of a connection, which apply to contacts created later.
struct Settings {
    std::chrono::milliseconds connect_timeout{5'000}, timeout{60'000}, build_timeout{3'600'000};
    std::filesystem::path server_key{}, own_key{};
};

/// Holds the timeout, cancellation and progress of one call.
struct Control {
    std::optional<std::chrono::milliseconds> timeout{};  ///< instead of that of the settings
    std::stop_token stop{};
    /// Receives the stage of the work and its fraction, 0..1, in the calling thread. May be empty.
    std::function<void(const std::string& stage, double fraction)> on_progress{};
};

/// Represents an open contact. Use it in one thread at a time; failed calls leave it unchanged. Calls throw
/// InvalidArgument, StatusError with the daemon's codes and reasons, and other exceptions in failure.hpp.
class OpenContact {
   public:
    virtual ~OpenContact() = default;
    /// Arrays of the solution are empty unless `input.fields` names them.
    virtual StepReply step(const StepInput& input, const Control& control) = 0;
    /// Saves the state of the contact and returns its name.
    virtual std::string save(const Control& control) = 0;
    virtual void restore(const std::string& state, const Control& control) = 0;
    virtual void forget(const std::string& state, const Control& control) = 0;
    /// This is the last call.
    virtual void close(const Control& control) = 0;
    virtual const IcUses& ics() const = 0;
};

/// Holds the inputs of a wheel on its rail, and the requested arrays of its patches.
struct WheelInput {
    WheelRailSetup setup;
    WheelRailState state;
    SolutionFields fields;
    bool gap = false;
    bool again = false;  ///< repeats the last solve from its initial state
};

/// Holds the inputs of both wheels of a wheelset.
struct WheelsetInput {
    WheelsetSetup setup;
    WheelsetState state;
    SolutionFields fields;
    bool gap = false;
};

/// Solves a wheel on its rail. For one thread at a time. An unchanged set-up is kept, and a solve starts from the end
/// of the previous one: from estimates, and for transient motions from tractions.
class OpenWheel {
   public:
    virtual ~OpenWheel() = default;
    /// Returns whether the next solve of such a set-up continues from an earlier one, and states remain valid.
    virtual bool goes_on_with(const WheelRailSetup& setup) const = 0;
    /// Arrays are empty unless requested. Throws as OpenContact, naming "setup.track.gauge", ...
    virtual WheelRailSolution solve(const WheelInput& input, const Control& control) = 0;
    /// Saves the state of the wheel and returns its name. First opens it with the set-up if necessary.
    virtual std::string save(const WheelRailSetup& setup, const Control& control) = 0;
    virtual void restore(const std::string& state, const Control& control) = 0;
    virtual void forget(const std::string& state, const Control& control) = 0;
    /// Solves both wheels of a wheelset within the tolerances, from the end of the last such solve of the same set-up:
    /// in process with its estimates, with a daemon at its height and roll.
    virtual WheelsetSolution solve_wheelset(const WheelsetInput& input, const Control& control) = 0;
};

/// Holds the part of one wheel in a call for several.
struct WheelCall {
    OpenWheel& wheel;
    const WheelInput& input;
    const Control& control;
};
/// Holds the solution of a wheel, or the exception of its solve.
using WheelResult = std::variant<WheelRailSolution, std::exception_ptr>;

/// Thread-safe.
class Backend {
   public:
    virtual ~Backend() = default;
    /// Returns when the tables are available. `spec` has passed validate_opening.
    virtual std::unique_ptr<OpenContact> open(const SessionSpec& spec, const Settings& settings,
                                              const Control& control) const = 0;
    /// Returns the frames of strips of a section, each `ds` wide. Throws as strip_frames does, below
    /// "ics.section".
    virtual std::vector<StripFrame> frames(const Section& section, int columns, double ds, const Settings& settings,
                                           const Control& control) const = 0;
    /// Sends nothing yet.
    virtual std::unique_ptr<OpenWheel> open_wheel(const Settings& settings) const = 0;
    /// Solves wheels that one user has opened here, each as in a separate solve: in process with this number of threads
    /// (0: the number of processors); with a daemon in one message, which ends for all when it ends for one. A wheel
    /// that fails does not affect the others.
    virtual std::vector<WheelResult> solve_many(std::span<const WheelCall> calls, int threads) const = 0;
    /// Throws if no contact can be solved now.
    virtual void ping(const Settings& settings) const = 0;
};

/// Returns the spec of the smallest table with these columns, of any material.
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

/// Returns the backend in process. Each library defines it; libcontactd throws StatusError (UNIMPLEMENTED).
std::unique_ptr<Backend> make_local_backend();
bool has_local_backend();

}  // namespace contactd::c
