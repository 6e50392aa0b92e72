// Computes wear of a solved contact.
#pragma once

#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

/// Holds the positions of the rows of a grid, and the creepages of a plane motion.
struct WearPlace {
    std::vector<WearRow> rows{};  ///< one per row of the grid; only y, z and angle are used
    double xi = 0, eta = 0;
};

/// Returns the place of a problem outside a wheel-rail contact: its rows on a plane, or on the strips of curved
/// columns.
WearPlace wear_place(const ContactProblem& problem, const Rolling& rolling);

/// Computes wear by the laws of the request for steady rolling along x. Adds warnings for users to those of the
/// solution, whose slip is relative.
ContactWear contact_wear(const WearRequest& request, const ContactProblem& problem, const WearPlace& place,
                         ContactSolution& solution);

}  // namespace contactd
