// Computes displacements of the surfaces under the tractions of a solution.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/grid.hpp"
#include "contactd/influence_operator.hpp"

namespace contactd {

/// Adds the displacements of the upper body minus those of the lower one (mm), u = A p, and the elastic energy.
void find_displacements(const Grid& grid, const InfluenceOperator& influence, ContactSolution& solution);

}  // namespace contactd
