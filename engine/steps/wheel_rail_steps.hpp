// Solves the numbered steps of one wheel on its rail.
#pragma once

#include "contactd/observer.hpp"
#include "contactd/session.hpp"
#include "engine/steps/contact_steps.hpp"
#include "engine/wheel_rail/prepared_contacts.hpp"

namespace contactd::engine {

/// Steady rolling has no history; the previous step only determines the start of searches and solvers. Allows one call
/// at a time.
class WheelRailSteps {
   public:
    WheelRailSteps(PreparedContacts::Contact contact, bool accept_unconverged);

    const WheelRailSetup& setup() const { return opened_->setup(); }

    /// Returns the contact as opened, or with the friction of a step. Throws InvalidArgument ("friction.mu",
    /// ...).
    const WheelRailContact& contact_with(const std::optional<WheelRailFriction>& friction);
    /// Solves the step of such a contact after `before`, and stores the state for the next one in `after`. Throws as
    /// WheelRailContact::solve, and StatusError (NOT_CONVERGED) unless unconverged steps are accepted.
    WheelRailSolution solve(const WheelRailContact& contact, const StepState& before, const WheelRailState& state,
                            StepState& after, Observer& observer) const;

   private:
    const PreparedContacts::Contact opened_;
    const bool accept_unconverged_;
    std::optional<WheelRailContact> other_friction_{};  // contact of the last step that named a friction
};

}  // namespace contactd::engine
