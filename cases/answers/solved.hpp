// A contact problem that was solved, with what follows from it.
#pragma once

#include <array>
#include <optional>

#include "answers/element_values.hpp"
#include "contactd/contact.hpp"

namespace contactd::cases {

/// Derivatives of forces by approach and motion, [out][in]: Fn, Fx and Fy over fstat Fn, Mz; by approach, the two
/// creepages or shifts, spin or rotation. In mm, N, rad.
using Sensitivities = std::array<std::array<double, 4>, 4>;

struct Solved {
    ContactProblem problem;
    ContactSolution solution;
    PlasticSlip plastic_before{}, plastic{};       ///< of a layer that yields, where the step began and where it ended
    std::optional<Sensitivities> sensitivities{};  ///< where they were asked for
    /// Names what a patch of a wheel on a rail has and its contact problem does not, which can not be solved again
    /// then.
    const char* beyond = nullptr;
    double spin_x = 0, spin_y = 0;  ///< centre of spin (mm)
};

}  // namespace contactd::cases
