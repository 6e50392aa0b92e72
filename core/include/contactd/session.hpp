// Defines sessions: the numbered steps of a simulation (docs/sessions.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/ic_reply.hpp"
#include "contactd/status.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

/// Describes the opening of a session.
struct SessionSpec {
    ContactSetup setup;  ///< the common part of all steps
    /// This is the default load of steps, and the first one starts from `previous`. Each step must provide those of
    /// gap, approach and Fn that are absent here.
    ContactLoad load{};
    std::optional<double> lease_seconds{};
    bool accept_unconverged = false;  ///< whether steps that missed a tolerance are accepted
};

/// Describes the opening of a session of a wheel on its rail.
struct WheelRailSessionSpec {
    WheelRailSetup setup{};
    std::optional<double> lease_seconds{};
    bool accept_unconverged = false;  ///< see SessionSpec; also applies to the searches for forces
};

/// Describes an open session.
struct SessionReply {
    std::string session;  ///< name of the session, which is the key to it
    double lease_seconds = 0;
    std::size_t bytes = 0;
    IcUses ics{};
};

/// Describes the state of a session, and the common part of all its steps.
struct SessionInfo {
    long long step = 0;  ///< number of the last step
    double lease_seconds = 0;
    std::size_t states = 0;              ///< saved states
    std::size_t bytes = 0;               ///< memory, including saved states
    std::optional<Grid> grid{};          ///< of a contact
    std::optional<MotionKind> motion{};  ///< for a contact; absent without friction
    std::optional<Side> side{};          ///< side of a wheel on its rail
    IcUses ics{};
};

/// Describes the input of a step. Omitted fields are those of the opening of the session.
struct StepInput {
    std::optional<double> approach{}, Fn{};  ///< at most one of the two
    std::optional<Gap> gap{};
    std::optional<FrictionLaw> friction{};
    std::optional<Motion> motion{};  ///< complete: all its fields are sent
    RigidSlip rigid_slip{};          ///< empty: as before
    /// If set, repeats the last requested step; if that step was solved, it is undone first. An integrator repeats a
    /// step until it accepts the result.
    bool again = false;
    std::optional<bool> derivatives{};    ///< whether the answer includes them
    std::optional<bool> displacements{};  ///< whether the answer includes displacements and the elastic energy
    SolutionFields fields{};              ///< requested arrays
};

struct StepReply {
    long long step = 0;
    ContactSolution solution;  ///< its arrays are empty unless they were requested
};

/// Describes the complete input of a step of a wheel on its rail: nothing of the previous input is kept.
struct WheelRailStepInput {
    WheelRailState state{};
    std::optional<WheelRailFriction> friction{};  ///< for this step, if it differs from that of the opening
    bool again = false;                           ///< as in StepInput
    SolutionFields fields{};                      ///< requested arrays of each patch
    bool gap = false;                             ///< whether the gap is requested, too
    /// The answer includes the patches if this is set. Without them, most of a message is saved.
    bool patches = true;
};

struct WheelRailStepReply {
    long long step = 0;
    WheelRailSolution solution;  ///< arrays of its patches are empty unless they were requested
};

/// Holds the solution of each of many steps, or the reason why there is none.
using StepOrStatus = std::variant<StepReply, Status>;
using AnyStepOrStatus = std::variant<StepReply, WheelRailStepReply, Status>;

}  // namespace contactd
