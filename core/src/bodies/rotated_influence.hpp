// From half-spaces that turn from row to row to the operators of a contact.
#pragma once

#include <memory>
#include <span>

#include "contactd/contact_influence.hpp"
#include "operators/rotated/midway_kernels.hpp"

namespace contactd {

/// Holds the part that operators of half-spaces share on all grids of one size, wherever their rows lie and however
/// these turn.
struct MidwayInfluence {
    ContactInfluence flat;  ///< of rows that lie side by side
    /// Coefficients between rows, which reach as far beyond the grid as a step of whole elements does.
    std::shared_ptr<const MidwayKernels> current;
    /// Their change over a step that is not of whole elements, by parity; else null.
    std::shared_ptr<const MidwayKernels> natural, opposite;
};

/// A thousandth of the error that half-spaces which turn have anyway.
inline constexpr double largest_change = 1e-6;

/// `flat` has the operators of the problem for rows that are not turned. The bodies are half-spaces. Throws
/// InvalidArgument: "friction.rolling.chi" and ".dq" for a step that is not along x, or longer than the grid; and
/// Cancelled.
MidwayInfluence midway_influence(const ContactProblem& problem, ContactInfluence flat, const Observer& observer = {});

/// Returns operators of rows in these frames (shape [ny]), of which the angles count: those of rotated_half_space. No
/// coefficient of large patches is changed by more than `largest_change` of zz of an element on itself, where products
/// leave out large wavenumbers of distant rows; patches of few rows have none that is worth it.
ContactInfluence rotated_influence(const ContactProblem& problem, const MidwayInfluence& midway,
                                   std::span<const StripFrame> frames);

}  // namespace contactd
