// Sessions: the numbered steps of a simulation (docs/sessions.md).
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

/// The opening of a session.
struct SessionSpec {
    ContactSetup setup;  ///< what all steps have in common
    /// The load of steps that do not state it; `previous` is where the first one starts. Of gap, approach and Fn every
    /// step names what is absent here.
    ContactLoad load{};
    std::optional<double> lease_seconds{};
    bool accept_unconverged = false;  ///< whether steps count that missed a tolerance
};

/// The opening of a session of a wheel on its rail.
struct WheelRailSessionSpec {
    WheelRailSetup setup{};
    std::optional<double> lease_seconds{};
    bool accept_unconverged = false;  ///< as in SessionSpec; of the searches for forces, too
};

/// An open session.
struct SessionReply {
    std::string session;  ///< its name, the key to it
    double lease_seconds = 0;
    std::size_t bytes = 0;
    IcUses ics{};
};

/// Where a session is, and what all its steps have in common.
struct SessionInfo {
    long long step = 0;  ///< number of the last one
    double lease_seconds = 0;
    std::size_t states = 0;              ///< saved ones
    std::size_t bytes = 0;               ///< with those
    std::optional<Grid> grid{};          ///< of a contact
    std::optional<MotionKind> motion{};  ///< of a contact; none without friction
    std::optional<Side> side{};          ///< of a wheel on its rail
    IcUses ics{};
};

/// The input of a step; fields that it leaves out are as the session was opened.
struct StepInput {
    std::optional<double> approach{}, Fn{};  ///< one at most
    std::optional<Gap> gap{};
    std::optional<FrictionLaw> friction{};
    std::optional<Motion> motion{};  ///< whole: all its fields are sent
    RigidSlip rigid_slip{};          ///< empty: as before
    /// The step asked for last is asked for anew: where it was solved it is taken back first. So an integrator tries a
    /// step until it is content.
    bool again = false;
    std::optional<bool> derivatives{};    ///< whether the answer has those
    std::optional<bool> displacements{};  ///< likewise
    SolutionFields fields{};              ///< wanted back
};

struct StepReply {
    long long step = 0;
    ContactSolution solution;  ///< its arrays are empty unless they were asked for
};

/// The input of a step of a wheel on its rail, whole: nothing of the state is as it was.
struct WheelRailStepInput {
    WheelRailState state{};
    std::optional<WheelRailFriction> friction{};  ///< for this step, where it is not as the session was opened
    bool again = false;                           ///< as in StepInput
    SolutionFields fields{};                      ///< wanted back of each patch
    bool gap = false;                             ///< whether that is, too
    /// Whether the answer has its patches at all. Simulations that only take forces save most of a message.
    bool patches = true;
};

struct WheelRailStepReply {
    long long step = 0;
    WheelRailSolution solution;  ///< arrays of its patches are empty unless they were asked for
};

/// Each of many steps has its solution, or says why there is none.
using StepOrStatus = std::variant<StepReply, Status>;
using AnyStepOrStatus = std::variant<StepReply, WheelRailStepReply, Status>;

}  // namespace contactd
