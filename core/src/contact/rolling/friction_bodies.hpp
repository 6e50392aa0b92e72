// Represents shifting or rolling bodies for Newton's method on the friction law.
#pragma once

#include <memory>

#include "contact/newton/compliance.hpp"
#include "contact/support/contact_elements.hpp"
#include "contactd/grid.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/step_operator.hpp"
#include "rolling_compliance.hpp"

namespace contactd {

/// Holds the operator from tractions to slip: C of steady rolling if there is an `increment`, otherwise A.
struct FrictionBodies {
    const InfluenceOperator& influence;
    const StepOperator* increment;  ///< null for shifts
    Grid grid;
    double step_x = 0, step_y = 0;  ///< see RollingBodies, if there is an `increment`
    /// Levels of the preconditioner of steady rolling reduce the number of iterations, but each iteration costs more.
    PreconditionerLevels levels = PreconditionerLevels::on_many_elements;
};

/// Creates the compliance. The bodies' operators and the contact must outlive it.
std::unique_ptr<Compliance> compliance_of(const FrictionBodies& bodies, const Contact& contact);

}  // namespace contactd
