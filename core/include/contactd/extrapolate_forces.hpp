// Extrapolates the tangential forces of steady rolling to elements of zero size.
#pragma once

#include <functional>

#include "contactd/contact.hpp"

namespace contactd {

/// Solves a problem on one of the grids.
using SolveOnGrid = std::function<ContactSolution(const ContactProblem& problem)>;

/// Replaces the tangential forces and the frictional power of a solved problem by extrapolated ones, and the normal
/// force by Hertz's; does nothing unless the problem requests an accuracy, and without contact or friction. Grids of n
/// x 2n elements, n along the rolling direction, cover the box around the contact ellipse, and spin is evaluated a
/// quarter of a step ahead. Their forces have an error proportional to 1/n for smooth tractions, so 2 F_2n - F_n has
/// nearly none. n is doubled until two extrapolations differ by little enough, up to 144 or until the solver needs many
/// iterations; the evidence reports the last two grids, and a warning errors that are larger than requested.
///
/// The forces over mu Fn depend on a/b and scaled creepages only. Problems passed to `solve` are scaled to ab = 1, G =
/// 1 and mu Fn = 1, so that all contacts of one a/b have the same operators. Throws InvalidArgument ("gap") for a/b
/// beyond 1/20 to 20, and whatever `solve` throws.
void extrapolate_forces(const ContactProblem& problem, ContactSolution& solution, const SolveOnGrid& solve);

}  // namespace contactd
