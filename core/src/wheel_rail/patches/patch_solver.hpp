// Solves the contact problem of a contact patch.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/observer.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// Returns the motion of a patch with these creepages and elements of length dx. A wheel without a velocity gets a
/// shift of zero.
Motion motion_of(const Creepages& creepages, double dx, const WheelRailSetup& setup, const WheelRailState& state);

/// Returns the contact problem of a candidate patch, without the initial state of a transient step.
ContactProblem problem_of(const WheelRailSetup& setup, const WheelRailState& state,
                          const geometry::CandidatePatch& found, const geometry::RailSurface& rail);

/// Returns the extended regions of overlap on the grid of a right wheel's patch, without regions that have no element.
/// Returns nothing if fewer than two overlap or none has an element.
std::optional<ContactRegions> contact_regions(const ContactPlace& place, const PatchRules& rules);

/// Solves the problem on the strips of its patch. Its regions with a weighted interaction are those of a
/// ContactProblem.
ContactSolution solve_patch(ContactProblem problem, const ContactPlace& place, const PatchStrips& strips,
                            const PatchRules& rules, const InfluenceSource& influences, Observer& observer);

/// Adds the requested fatigue results to the final solution of a patch. Stresses take at least as long as a solve, so
/// searches for a height omit them.
void add_fatigue(const WheelRailSetup& setup, const ContactPlace& place, ContactSolution& solution, Observer& observer);

}  // namespace contactd
