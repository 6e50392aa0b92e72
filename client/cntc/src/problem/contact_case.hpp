// One contact problem of a result element: what was set, and what came of the last solve.
#pragma once

#include <array>
#include <map>
#include <mutex>
#include <optional>

#include "contactd/subsurface_stress.hpp"
#include "problem/area.hpp"
#include "problem/contact_solver.hpp"
#include "problem/element_values.hpp"
#include "problem/settings.hpp"

namespace contactd::cntc {

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
};

/// Stresses in a block, as they are read: z > 0 inside the upper body.
struct SolvedBlock {
    GivenBlock given;
    StressBlock points;  ///< (mm), z as the caller has it
    SubsurfaceStress stress;
    SubsurfaceDisplacement displacement;  ///< (mm)
};

/// Seconds that solves took.
struct CalculationTime {
    double cpu = 0, wall = 0;
};

struct ContactCase {
    std::mutex mutex;  ///< held by whoever uses the rest
    Settings settings;
    ContactSolver solver;
    std::optional<Solved> solved;       ///< the last case, which the next one may continue from
    bool current = false;               ///< whether it is what was asked for last: a refused case cannot be read
    std::map<int, SolvedBlock> blocks;  ///< of the last solve
    CalculationTime time;
};

/// Throws Refused where the last case was not solved.
const Solved& solution_of(const ContactCase& problem);

/// Throws Refused where a solver missed its tolerance.
void require_converged(const ContactEvidence& evidence);

/// Solves what is set, and keeps it. Returns what cntc_calculate answers where it is not negative. Throws Refused,
/// where solvers missed their tolerances with what they found kept.
int calculate(ContactCase& problem);

}  // namespace contactd::cntc
