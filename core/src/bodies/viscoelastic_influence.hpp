// From half-spaces of the standard linear solid to the operators of their rolling contact.
#pragma once

#include "contactd/contact_influence.hpp"

namespace contactd {

/// `elastic` holds the coefficients of the pair at once, of bodies without instant creep. The problem rolls steadily
/// along x, which validate() sees to.
/// Throws InvalidArgument ("friction.rolling") where it does not, and Cancelled.
ContactInfluence viscoelastic_influence(const ContactProblem& problem, IcTable elastic, const Observer& observer);

}  // namespace contactd
