// The numbered steps of one simulation, each of which starts where the one before ended.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "contactd/observer.hpp"
#include "contactd/session.hpp"
#include "contactd/wheel_rail_estimates.hpp"
#include "engine/ics/cache/influence_cache.hpp"
#include "engine/ics/ic_pair.hpp"

namespace contactd::engine {

/// Where a simulation is: all that a step leaves to the next one. Whoever holds a state has saved it.
struct StepState {
    long long step = 0;
    SurfaceState tractions{};
    std::optional<Motion> motion{};
    WheelRailEstimates wheel_rail{};  ///< of the steps of a wheel on its rail, which leave nothing else
};

/// Solves steps from a state; which state that is, its user knows. For one call at a time.
class ContactSteps {
   public:
    /// `influence` is that of the set-up, made of `ics`.
    ContactSteps(SessionSpec spec, IcAnswers ics, CachedInfluence influence);

    /// The set-up that all steps have in common, and the load that holds for those that do not state it.
    const ContactProblem opened;
    const bool accept_unconverged;  ///< whether steps count that missed a tolerance

    StepState start() const { return {0, opened.previous, {}}; }

    /// Overrides fields of the problem, which is as opened, by those of a step. `last` is the motion of the step
    /// before: the creepage it found for a prescribed force is the estimate now, unless the step names another.
    using Overlay = std::function<void(const std::optional<Motion>& last, ContactProblem& problem)>;
    /// The step after `before`. Operators for another rolling step than before come from `cache`. Throws as
    /// solve_contact, what `overlay` throws, and StatusError (NOT_CONVERGED) unless such steps count.
    ContactSolution solve(const StepState& before, const Overlay& overlay, InfluenceCache& cache, Observer& observer);
    /// Where that leads; takes the tractions of the solution.
    static StepState after(const StepState& before, ContactSolution&& solution);

    const IcAnswers& ics() const { return ics_; }

   private:
    void fit_influence(InfluenceCache& cache, const Observer& observer);

    const IcAnswers ics_;
    ContactProblem problem_;  // of the step that runs
    CachedInfluence influence_;
    std::array<double, 3> rolling_step_;  // that influence_ is for
};

/// Overrides a problem by the typed fields of a step, those of `session.step` on the wire. Throws InvalidArgument
/// naming the field when gap, load or friction are missing.
void overlay(const StepInput& input, const std::optional<Motion>& last, ContactProblem& problem);

}  // namespace contactd::engine
