// Newton's method on the friction law for a whole grid: shifts and rolling, the motion known or found from forces.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "contact/newton/force_border.hpp"
#include "contact/rolling/coarse_start.hpp"
#include "contact/rolling/rolling.hpp"
#include "contactd/contact.hpp"
#include "contactd/observer.hpp"

namespace contactd {

struct FrictionTask {
    std::span<const double> bound;
    const Field& rigid;                 ///< w (mm), without what the forces make of it
    std::optional<ForcesGiven> forces;  ///< where given, a uniform part of w is found
    Pair uniform = Pair::Zero();        ///< an estimate of that (mm)
    const Field& estimate;              ///< of the tractions; zero is none
    SolverSettings settings;
};

struct FrictionSolution : RollingSolution {
    Pair uniform = Pair::Zero();  ///< rigid slip that the forces take (mm)
    double force_residual = 0;    ///< |F - prescribed| over the largest that friction carries
};

class FrictionSolver {
   public:
    /// The operators outlive it.
    explicit FrictionSolver(const FrictionBodies& bodies);
    ~FrictionSolver();

    /// From the estimate, or where that is poor from tractions on a coarser grid. Converged means the law as of
    /// solve_steady_rolling, and the forces.
    FrictionSolution solve(const FrictionTask& task, Observer& observer);
    /// The same from the last solution, with all that was learnt there while the contact area stands and that solution
    /// has converged; otherwise from the estimate.
    FrictionSolution solve_again(const FrictionTask& task, Observer& observer);

   private:
    class Area;
    FrictionSolution finish(const FrictionTask& task, Observer& observer);

    const FrictionBodies bodies_;
    std::unique_ptr<Area> area_;
};

}  // namespace contactd
