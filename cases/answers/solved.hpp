// Holds a solved contact problem with derived results.
#pragma once

#include <array>
#include <optional>

#include "answers/element_values.hpp"
#include "contactd/contact.hpp"

namespace contactd::cases {

/// Holds derivatives of forces with respect to approach and motion, [out][in]. Outputs are Fn, Fx and Fy relative to
/// fstat Fn, and Mz. Inputs are the approach, the two creepages or shifts, and the spin or rotation. In mm, N, rad.
using Sensitivities = std::array<std::array<double, 4>, 4>;

struct Solved {
    ContactProblem problem;
    ContactSolution solution;
    PlasticSlip plastic_before{}, plastic{};       ///< for a layer that yields, at the start and end of the step
    std::optional<Sensitivities> sensitivities{};  ///< if requested
    /// The name of a feature of a patch on a rail that its contact problem lacks, so that it cannot be solved again.
    const char* beyond = nullptr;
    double spin_x = 0, spin_y = 0;  ///< centre of spin (mm)
};

}  // namespace contactd::cases
