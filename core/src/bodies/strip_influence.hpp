// Makes the operators of a contact from a strip table.
#pragma once

#include "contactd/contact_influence.hpp"
#include "contactd/strip_table.hpp"

namespace contactd {

/// Returns the operators. `pair` holds the coefficients of both bodies on the grid's rows, in the frames of the lower
/// one; of the bodies of `problem` only the materials matter. A step of rolling by whole elements uses the table's own
/// numbers. For other steps, the difference to the half-spaces of the materials is interpolated, as in shifted_table;
/// beyond the last offset of the table, it is constant. Throws InvalidArgument ("grid" if the table does not fit,
/// "friction.rolling.chi" and ".dq" for a step that is not along x, or longer than the grid), and Cancelled.
ContactInfluence strip_influence(const ContactProblem& problem, StripTable pair, const Observer& observer = {});

}  // namespace contactd
