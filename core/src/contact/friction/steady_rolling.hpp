// Solves the steady state of rolling with a known motion.
#pragma once

#include <span>

#include "contact/rolling/rolling.hpp"
#include "contactd/observer.hpp"
#include "friction_solver.hpp"

namespace contactd {

/// Solves the steady state, p_previous = p: s = w + C p, directly by FrictionSolver or, if that fails, as
/// march_to_steady_state. Arrays, estimates and errors are those of solve_tangential. Also throws InvalidArgument for a
/// step or grid that does not fit.
RollingSolution solve_steady_rolling(const RollingBodies& bodies, std::span<const double> bound,
                                     std::span<const double> rigid_x, std::span<const double> rigid_y,
                                     const SolverSettings& settings, std::span<const double> initial_x,
                                     std::span<const double> initial_y, Observer& observer);

/// Continues after the direct method has stopped: transient steps from the solution found until it is nearly steady,
/// and then the direct method again. `task` is that of the direct method, without forces. evidence.iterations continues
/// the count of direct iterations.
RollingSolution march_to_steady_state(const FrictionBodies& bodies, const FrictionTask& task,
                                      const RollingSolution& found, Observer& observer);

}  // namespace contactd
