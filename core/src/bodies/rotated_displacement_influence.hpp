// Makes the operators of a contact from half-spaces along the loaded row.
#pragma once

#include <span>

#include "contactd/contact_influence.hpp"

namespace contactd {

/// Returns operators of the half-spaces of the bodies' materials: displacements of a flat surface, rotated from the
/// axes of the loaded row to those of the observed one. `angles` (rad, shape [ny]) are those of the rows' normals, from
/// the lower body to the upper one, positive towards +y. Tractions stay along the axes of their row. Throws Cancelled.
ContactInfluence rotated_displacement_influence(const ContactProblem& problem, std::span<const double> angles,
                                                const Observer& observer = {});

}  // namespace contactd
