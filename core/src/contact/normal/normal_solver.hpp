// Solves normal contact for a sequence of gaps: selects the start of NORM and its elements, and keeps data between
// solves.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"
#include "normal.hpp"

namespace contactd {

struct NormalTask {
    std::span<const double> gap;         ///< undeformed gap (mm), minus the approach if that is prescribed
    std::optional<double> pressure_sum;  ///< prescribed instead of the approach: Fn / element area
    SolverSettings settings;
    bool to_be_refined = false;  ///< whether another solve follows; then solve_again() need not find overlap beyond the
                                 ///< last box
};

class NormalBox;

class NormalSolver {
   public:
    /// The operator must outlive this object.
    explicit NormalSolver(const InfluenceOperator& influence);
    ~NormalSolver();

    /// Solves like solve_normal and solve_normal_force.
    NormalSolution solve(const NormalTask& task, std::span<const double> initial, const PressureEstimate& closed_form,
                         Observer& observer);
    /// Solves for a gap near the last one. If that was solved, starts from its solution and without an initial product;
    /// otherwise starts from `initial`.
    NormalSolution solve_again(const NormalTask& task, std::span<const double> initial, Observer& observer);

   private:
    const InfluenceOperator& influence_;
    std::unique_ptr<NormalBox> box_;  // of the last solution
};

}  // namespace contactd
