// Hertz, and simplified models of friction, as answers to a contact problem.
#pragma once

#include "closed_forms/penetration_contact.hpp"
#include "contactd/contact.hpp"

namespace contactd {

/// `penetration` has the pressures of problem.normal_model, where that is not of_model; models of rolling take the
/// ellipse that is equivalent to their elements. For model hertz (Hertz, with Cattaneo-Mindlin for shifts and
/// Vermeulen-Johnson for rolling) and fastsim, fastrip and polach (Hertz, with these for rolling). Of line contacts,
/// which hertz alone knows, it is Hertz, Cattaneo and Carter. Forces, areas and pmax are those of the whole ellipse,
/// arrays samples. `problem` is valid. Throws InvalidArgument for what these theories do not know.
ContactSolution solve_by_simplified_model(const ContactProblem& problem,
                                          const PenetrationContact* penetration = nullptr);

}  // namespace contactd
