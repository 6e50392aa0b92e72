// Rolling contact fatigue of a contact that was solved.
#pragma once

#include <vector>

#include "contactd/contact.hpp"
#include "contactd/observer.hpp"
#include "wear/contact_wear.hpp"

namespace contactd {

/// Where the rows of a grid lie, and the creepages of a plane motion.
struct FatiguePlace {
    WearPlace wear;
    /// Angles of all rows (rad), of the tangent from y towards the lower body's outside; none of a plane contact.
    std::vector<double> angles{};
};

/// The place of a problem by itself: its rows on a plane, or on the strips of curved columns.
FatiguePlace fatigue_place(const ContactProblem& problem, const Rolling& rolling);

/// Fatigue as the problem's `fatigue` asks for it, of steady rolling along x. What a user of it should know is added to
/// the warnings of the solution. Reports the stage "subsurface" where stresses are wanted. Throws InvalidArgument
/// ("fatigue.passage.depths[2]", ...) for depths below a body's base, and Cancelled.
ContactFatigue contact_fatigue(const ContactProblem& problem, const FatiguePlace& place, ContactSolution& solution,
                               Observer& observer);

}  // namespace contactd
