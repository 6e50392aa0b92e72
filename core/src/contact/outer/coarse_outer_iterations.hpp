// Starts the outer iterations of dissimilar bodies with many elements on the coarser grid.
#pragma once

#include <optional>

#include "contact/support/contact_elements.hpp"
#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "contactd/observer.hpp"

namespace contactd {

struct OuterStart {
    Field tractions;  ///< on the grid, within the bound
    Motion motion;    ///< the given motion, with components computed for prescribed forces
};

/// Iterates roughly between pressures and tractions on the coarser grid. `distance` is the problem's undeformed
/// distance, `bound` the friction bound for approximate pressures. Returns nothing if few elements are in contact, if
/// there is no coarser grid, if the problem has more than bodies, load and motion, or if the iteration did not
/// converge.
std::optional<OuterStart> outer_iterations_on_coarser(const ContactProblem& problem, const ContactInfluence& influence,
                                                      const std::vector<double>& distance,
                                                      const std::vector<double>& bound, const Observer& observer);

}  // namespace contactd
