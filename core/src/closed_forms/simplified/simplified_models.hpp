// Solves contact problems by Hertz and by simplified models of friction.
#pragma once

#include "closed_forms/penetration_contact.hpp"
#include "contactd/contact.hpp"

namespace contactd {

/// Solves a valid `problem` with model hertz (Hertz, with Cattaneo-Mindlin for shifts and Vermeulen-Johnson for
/// rolling), or fastsim, fastrip or polach (Hertz, with these for rolling). Line contacts, which only hertz supports,
/// are solved by Hertz, Cattaneo and Carter. `penetration` holds the pressures of problem.normal_model if that is not
/// of_model; models of rolling then use the ellipse that is equivalent to their elements. Forces, areas and pmax are
/// those of the whole ellipse, arrays are samples. Throws InvalidArgument for problems that these theories do not
/// cover.
ContactSolution solve_by_simplified_model(const ContactProblem& problem,
                                          const PenetrationContact* penetration = nullptr);

}  // namespace contactd
