// Wear of a contact that was solved.
#pragma once

#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Where the rows of a grid lie, and the creepages of a plane motion.
struct WearPlace {
    std::vector<WearRow> rows{};  ///< one a row of the grid, of which y, z and angle are of any meaning
    double xi = 0, eta = 0;
};

/// The place of a problem by itself: its rows on a plane, or on the strips of curved columns.
WearPlace wear_place(const ContactProblem& problem, const Rolling& rolling);

/// Wear by the laws of the request, of steady rolling along x. What a user of it should know is added to the
/// warnings of the solution, whose slip is relative.
ContactWear contact_wear(const WearRequest& request, const ContactProblem& problem, const WearPlace& place,
                         ContactSolution& solution);

}  // namespace contactd
