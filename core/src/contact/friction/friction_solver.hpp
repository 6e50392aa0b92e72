// Solves the friction law on a whole grid by Newton's method: shifts and rolling, with the motion prescribed or
// computed from forces.
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

/// Describes a layer that hardens or softens as it flows, on the grid (FlowLaw).
struct FlowTask {
    double first = 0, hardening = 0, least = 0;
    std::vector<double> before;  ///< yield stress of the particles before the step; empty for steady rolling
};

struct FrictionTask {
    std::span<const double> bound;
    const Field& rigid;                 ///< w (mm), without the uniform part that forces determine
    std::optional<ForcesGiven> forces;  ///< if given, a uniform part of w is computed
    Pair uniform = Pair::Zero();        ///< estimate of the uniform part (mm)
    const Field& estimate;              ///< estimate of the tractions; zero means none
    SolverSettings settings;
    bool estimate_is_good = false;  ///< whether the estimate must not be replaced by tractions of a coarser grid
    const FlowTask* flow = nullptr;
};

struct FrictionSolution : RollingSolution {
    Pair uniform = Pair::Zero();  ///< uniform rigid slip that the forces determine (mm)
    double force_residual = 0;    ///< |F - prescribed| over the largest force that friction carries
};

class FrictionSolver {
   public:
    /// The operators must outlive this object.
    explicit FrictionSolver(const FrictionBodies& bodies);
    ~FrictionSolver();

    /// Solves from the estimate, or if that is poor from tractions on a coarser grid. If the contact area is unchanged
    /// and the last solve has converged, starts from its solution and its previous steps.
    ///
    /// The solution has converged if the division is stable as in FrictionNewton, |p| <= g everywhere and |p| = g in
    /// slip hold exactly, forces are met, and evidence.residual <= tolerance. The residual is the larger of
    /// - the violation of the friction law, |s| in adhesion, |s x p|/g and s . p/g > 0 in slip, as a root mean square
    ///   over the contact relative to that of w, and
    /// - the estimated error of the tractions, the violation times an approximate inverse of the law's Jacobian,
    ///   relative to the tractions.
    FrictionSolution solve(const FrictionTask& task, Observer& observer);
    /// Returns tractions on all elements from which other solvers can start: those from which a solve without history
    /// would start. Afterwards, the solver is as after forget().
    Field first_tractions(const FrictionTask& task, Observer& observer);
    /// Makes the next solve independent of the last one.
    void forget();

   private:
    class Area;
    void start(const FrictionTask& task, Observer& observer);

    const FrictionBodies bodies_;
    std::unique_ptr<Area> area_;
};

}  // namespace contactd
