// Normal contact for one gap after another: what NORM starts from, on how many elements, and what it keeps.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"
#include "normal.hpp"

namespace contactd {

struct NormalTask {
    std::span<const double> gap;         ///< undeformed (mm), with the approach subtracted where that is prescribed
    std::optional<double> pressure_sum;  ///< prescribed instead of the approach: Fn / element area
    SolverSettings settings;
    bool to_be_refined = false;  ///< another solve follows: to go on need not look for overlap beyond the last box
};

class NormalBox;

class NormalSolver {
   public:
    /// The operator outlives it.
    explicit NormalSolver(const InfluenceOperator& influence);
    ~NormalSolver();

    /// Solves like solve_normal and solve_normal_force.
    NormalSolution solve(const NormalTask& task, std::span<const double> initial, const PressureEstimate& closed_form,
                         Observer& observer);
    /// Solves for a gap near the last one: where that was solved, from its solution and without a product to start
    /// with; otherwise from `initial`.
    NormalSolution solve_again(const NormalTask& task, std::span<const double> initial, Observer& observer);

   private:
    const InfluenceOperator& influence_;
    std::unique_ptr<NormalBox> box_;  // of the last solution
};

}  // namespace contactd
