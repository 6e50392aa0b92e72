// Computes rolling contact fatigue of a solved contact.
#pragma once

#include <vector>

#include "contactd/contact.hpp"
#include "contactd/observer.hpp"
#include "wear/contact_wear.hpp"

namespace contactd {

/// Holds the positions of the rows of a grid, and the creepages of a plane motion.
struct FatiguePlace {
    WearPlace wear;
    /// Holds the angles of all rows (rad), of the tangent from y towards the lower body's outside; empty for a plane
    /// contact.
    std::vector<double> angles{};
};

/// Returns the place of a problem outside a wheel-rail contact: its rows on a plane, or on the strips of curved
/// columns.
FatiguePlace fatigue_place(const ContactProblem& problem, const Rolling& rolling);

/// Computes the fatigue that the problem's `fatigue` requests, for steady rolling along x. Adds warnings for users to
/// those of the solution. Reports the stage "subsurface" if stresses are requested. Throws InvalidArgument
/// ("fatigue.passage.depths[2]", ...) for depths below a body's base, and Cancelled.
ContactFatigue contact_fatigue(const ContactProblem& problem, const FatiguePlace& place, ContactSolution& solution,
                               Observer& observer);

}  // namespace contactd
