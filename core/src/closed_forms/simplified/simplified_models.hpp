// Hertz and FASTSIM as answers to a contact problem.
#pragma once

#include "contactd/contact.hpp"

namespace contactd {

/// For model hertz (Hertz, with Cattaneo-Mindlin for shifts and Vermeulen-Johnson for rolling) and fastsim (Hertz, with
/// FASTSIM for rolling). Of line contacts, which hertz alone knows, it is Hertz, Cattaneo and Carter. Forces, areas and
/// pmax are those of the whole ellipse, arrays samples. `problem` is valid. Throws InvalidArgument for what these
/// theories do not know.
ContactSolution solve_by_simplified_model(const ContactProblem& problem);

}  // namespace contactd
