// From a place where wheel and rail touch to its contact problem and the solution.
#pragma once

#include "contactd/contact.hpp"
#include "contactd/observer.hpp"
#include "contactd/solve_wheel_rail.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// Returns the motion of a patch with these creepages and elements dx long; a wheel without a velocity is in a shift
/// that brings nothing.
Motion motion_of(const Creepages& creepages, double dx, const WheelRailSetup& setup, const WheelRailState& state);

/// Returns the contact problem of a candidate patch, without what a step that is not steady goes on from.
ContactProblem problem_of(const WheelRailSetup& setup, const WheelRailState& state,
                          const geometry::CandidatePatch& found, const geometry::RailSurface& rail);

/// Returns the regions of overlap with what lies around them, on the grid of a right wheel's patch, without those that
/// have no element; absent where fewer than two overlap or none has an element.
std::optional<ContactRegions> contact_regions(const ContactPlace& place, const PatchRules& rules);

/// Solves it, on the strips of its patch; regions of it with a weighted interaction are those of a ContactProblem.
ContactSolution solve_patch(ContactProblem problem, const ContactPlace& place, const PatchStrips& strips,
                            const PatchRules& rules, const InfluenceSource& influences, Observer& observer);

/// Adds what the set-up asks of fatigue, of the solution of a patch that stays. Stresses take as long as a solve, and
/// more, so that searches for a height leave them out.
void add_fatigue(const WheelRailSetup& setup, const ContactPlace& place, ContactSolution& solution, Observer& observer);

}  // namespace contactd
