// Solves the numbered steps of one simulation, each of which starts from the end of the previous one.
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

/// Holds the state of a simulation: all data that a step passes to the next one. To save a state, keep it.
struct StepState {
    long long step = 0;
    SurfaceState tractions{};
    std::optional<Motion> motion{};
    WheelRailEstimates wheel_rail{};  ///< applies to the steps of a wheel on its rail, which leave nothing else
};

/// Solves steps from a state that the caller keeps. Allows one call at a time.
class ContactSteps {
   public:
    /// `influence` belongs to the set-up and was made from `ics`.
    ContactSteps(SessionSpec spec, IcAnswers ics, CachedInfluence influence);

    /// Returns the common set-up of all steps, and the default load.
    const ContactProblem opened;
    const bool accept_unconverged;  ///< true if steps that missed a tolerance are accepted

    StepState start() const { return {0, opened.previous, {}}; }

    /// Overrides fields of the opened problem by those of a step. `last` is the motion of the previous step; the
    /// creepage that it found for a prescribed force is the estimate, unless the step gives another.
    using Overlay = std::function<void(const std::optional<Motion>& last, ContactProblem& problem)>;
    /// Solves the step after `before`. Operators for a different rolling step come from `cache`. Throws as
    /// solve_contact and `overlay`, and StatusError (NOT_CONVERGED) unless unconverged steps are accepted.
    ContactSolution solve(const StepState& before, const Overlay& overlay, InfluenceCache& cache, Observer& observer);
    /// Returns the next state; moves the tractions out of the solution.
    static StepState after(const StepState& before, ContactSolution&& solution);

    const IcAnswers& ics() const { return ics_; }

   private:
    void fit_influence(InfluenceCache& cache, const Observer& observer);

    const IcAnswers ics_;
    ContactProblem problem_;  // problem of the running step
    CachedInfluence influence_;
    std::array<double, 3> rolling_step_;  // that influence_ is for
};

/// Overrides a problem by the typed fields of a step, those of `session.step` on the wire. Throws InvalidArgument
/// naming the field when gap, load or friction are missing.
void overlay(const StepInput& input, const std::optional<Motion>& last, ContactProblem& problem);

}  // namespace contactd::engine
