// From a strip table to the operators of a contact.
#pragma once

#include "contactd/contact_influence.hpp"
#include "contactd/strip_table.hpp"

namespace contactd {

/// `pair` holds the coefficients of both bodies on the grid's rows, in the frames of the lower one; of the bodies of
/// `problem` only the materials count. A step of rolling by whole elements takes the table's own numbers; for another
/// one the difference to the half-spaces of the materials is interpolated, as in shifted_table. Beyond the last offset
/// of the table that difference stays as it is. Throws InvalidArgument: "grid" where the table does not fit,
/// "friction.rolling.chi" and ".dq" for a step that is not along x, or longer than the grid; and Cancelled.
ContactInfluence strip_influence(const ContactProblem& problem, StripTable pair, const Observer& observer = {});

}  // namespace contactd
