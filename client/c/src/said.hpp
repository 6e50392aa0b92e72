// What the setters of a contact have said, and the problem that this makes.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "contactd/session.hpp"

namespace contactd::c {

/// In whatever order it is said: friction, motion and force are put together when a call needs the problem.
struct Said {
    ContactProblem problem;  ///< but for friction and motion
    std::vector<double> mu;  ///< empty: no friction
    std::optional<KineticFriction> kinetic;
    std::optional<MotionKind> kind;  ///< of the motion, once it was said
    Shift shift;
    Rolling rolling;
    Force force;  ///< of either
    bool accept_unconverged = false;
    std::optional<double> lease_seconds;
    std::vector<SolutionField> fields;
    bool derivatives = false;
    std::optional<std::chrono::milliseconds> step_timeout;

    /// What differs from what the contact was opened with: steps have to name it, then.
    struct Changed {
        bool gap = false, friction = false, motion = false, rigid_slip = false;
    } changed;

    /// Puts the problem together. Throws InvalidArgument ("friction.mu") when what only friction knows was said
    /// without.
    const ContactProblem& stated();
    /// What session.open is told.
    SessionSpec opening();
    /// What a step is told. Throws InvalidArgument for what no step can solve.
    StepInput step();

    /// Takes over what a step has found under forces, as the estimate of the next: a session does so for steps that
    /// name no motion.
    void take_estimates(const std::optional<Motion>& found);
};

}  // namespace contactd::c
