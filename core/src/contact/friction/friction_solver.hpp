// Newton's method on the friction law for a whole grid: shifts and rolling, the motion known or found from forces.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/newton/force_border.hpp"
#include "contact/rolling/friction_bodies.hpp"
#include "contact/rolling/rolling.hpp"
#include "contactd/contact.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// A layer that hardens or softens as it flows, on the grid (FlowLaw).
struct FlowTask {
    double first = 0, hardening = 0, least = 0;
    std::vector<double> before;  ///< yield stress of the particles before the step; of steady rolling empty
};

struct FrictionTask {
    std::span<const double> bound;
    const Field& rigid;                 ///< w (mm), without what the forces make of it
    std::optional<ForcesGiven> forces;  ///< where given, a uniform part of w is found
    Pair uniform = Pair::Zero();        ///< an estimate of that (mm)
    const Field& estimate;              ///< of the tractions; zero is none
    SolverSettings settings;
    bool estimate_is_good = false;  ///< is not left for tractions of a coarser grid
    const FlowTask* flow = nullptr;
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

    /// From the estimate, or where that is poor from tractions on a coarser grid. While the contact area stands and the
    /// last solve has converged: from its solution, with all that was learnt there.
    ///
    /// Converged means that the division stands as FrictionNewton has it, that |p| <= g everywhere and |p| = g in slip
    /// hold exactly, that forces are met, and evidence.residual <= tolerance, the larger of
    /// - the violation of the friction law, |s| in adhesion, |s x p|/g and s . p/g > 0 in slip, as a root mean square
    ///   over the contact relative to that of w, and
    /// - the estimated error of the tractions, the violation times an approximate inverse of the law's Jacobian,
    ///   relative to the tractions.
    FrictionSolution solve(const FrictionTask& task, Observer& observer);
    /// The tractions on all elements that a solve which knows of no other would start from, for other solvers. Like
    /// forget() afterwards.
    Field first_tractions(const FrictionTask& task, Observer& observer);
    /// The next solve has nothing to do with the last one.
    void forget();

   private:
    class Area;
    void start(const FrictionTask& task, Observer& observer);

    const FrictionBodies bodies_;
    std::unique_ptr<Area> area_;
};

}  // namespace contactd
