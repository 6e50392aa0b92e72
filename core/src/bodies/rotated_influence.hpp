// Makes the operators of a contact from half-spaces that rotate from row to row.
#pragma once

#include <memory>
#include <span>

#include "contactd/contact_influence.hpp"
#include "operators/rotated/midway_kernels.hpp"

namespace contactd {

/// Holds the part that operators of half-spaces share on all grids of one size, independent of the positions and angles
/// of their rows.
struct MidwayInfluence {
    ContactInfluence flat;  ///< for rows in one plane
    /// Coefficients between rows extend as far beyond the grid as a step of whole elements.
    std::shared_ptr<const MidwayKernels> current;
    /// Hold the change of the coefficients over a step that is not of whole elements, by parity; null otherwise.
    std::shared_ptr<const MidwayKernels> natural, opposite;
};

/// Coefficients may change by this much, which is a thousandth of the error of rotated half-spaces.
inline constexpr double largest_change = 1e-6;

/// Returns the shared part for half-spaces; `flat` holds the operators of the problem for rows that are not rotated.
/// Throws InvalidArgument ("friction.rolling.chi" and ".dq") for a step that is not along x, or longer than the grid,
/// and Cancelled.
MidwayInfluence midway_influence(const ContactProblem& problem, ContactInfluence flat, const Observer& observer = {});

/// Returns the operators of rows in these frames (shape [ny]), of which only the angles matter; they are those of
/// rotated_half_space. In large patches, products omit large wavenumbers of distant rows if no coefficient changes by
/// more than `largest_change` of zz of an element on itself. In patches of few rows, this does not pay.
ContactInfluence rotated_influence(const ContactProblem& problem, const MidwayInfluence& midway,
                                   std::span<const StripFrame> frames);

}  // namespace contactd
