// The bodies as Newton's method on the friction law takes them, whether they shift or roll.
#pragma once

#include <memory>

#include "contact/newton/compliance.hpp"
#include "contact/support/contact_elements.hpp"
#include "contactd/grid.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/step_operator.hpp"
#include "rolling_compliance.hpp"

namespace contactd {

/// The operator from tractions to slip: C of steady rolling where there is an `increment`, otherwise A.
struct FrictionBodies {
    const InfluenceOperator& influence;
    const StepOperator* increment;  ///< null for shifts
    Grid grid;
    double step_x = 0, step_y = 0;  ///< as of RollingBodies, where there is an `increment`
    /// Levels of the preconditioner of steady rolling save iterations, but each costs more.
    PreconditionerLevels levels = PreconditionerLevels::on_many_elements;
};

/// The bodies' operators and the contact outlive it.
std::unique_ptr<Compliance> compliance_of(const FrictionBodies& bodies, const Contact& contact);

}  // namespace contactd
