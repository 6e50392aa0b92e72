// The steady state of rolling with a known motion.
#pragma once

#include <span>

#include "contact/rolling/rolling.hpp"
#include "contactd/observer.hpp"
#include "friction_solver.hpp"

namespace contactd {

/// The steady state, p_previous = p: s = w + C p, found directly by FrictionSolver, and where that does not get there
/// as march_to_steady_state does. Arrays, estimates and errors as of solve_tangential; also throws InvalidArgument for
/// a step or grid that does not fit.
RollingSolution solve_steady_rolling(const RollingBodies& bodies, std::span<const double> bound,
                                     std::span<const double> rigid_x, std::span<const double> rigid_y,
                                     const SolverSettings& settings, std::span<const double> initial_x,
                                     std::span<const double> initial_y, Observer& observer);

/// Where the direct way has stopped: the transient marches on from what was found until it stands, nearly, and the
/// direct way is tried again. `task` is the one that was tried, without forces. evidence.iterations goes on counting
/// those of the direct kind.
RollingSolution march_to_steady_state(const FrictionBodies& bodies, const FrictionTask& task,
                                      const RollingSolution& found, Observer& observer);

}  // namespace contactd
