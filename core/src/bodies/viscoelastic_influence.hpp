// Makes the operators of rolling contact from half-spaces of the standard linear solid.
#pragma once

#include "contactd/contact_influence.hpp"

namespace contactd {

/// Returns the operators. `elastic` holds the instantaneous coefficients of the pair, of bodies without instantaneous
/// creep. The problem rolls steadily along x, which validate() ensures. Throws InvalidArgument ("friction.rolling") if
/// it does not, and Cancelled.
ContactInfluence viscoelastic_influence(const ContactProblem& problem, IcTable elastic, const Observer& observer);

}  // namespace contactd
