// A layer between the bodies that yields: what its particles bring to a step, and what of the motion is flow.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/rolling/rolling.hpp"
#include "contactd/contact.hpp"
#include "friction_solver.hpp"

namespace contactd {

class LayerFlow {
   public:
    /// `problem` has a layer that yields, and outlives this.
    explicit LayerFlow(const ContactProblem& problem);

    /// A new step begins. `yield_stress` is that at the end of the step before, shape [ny, nx] (N/mm^2); empty: no
    /// particle has flowed.
    void begin(const std::vector<double>& yield_stress);

    /// Solvers take this of a layer that hardens or softens; else it is null.
    const FlowTask* task() const { return layer_.hardens() ? &task_ : nullptr; }
    /// Limits what friction can bear (N/mm^2) to what the layer bears, where that never changes.
    void limit(std::vector<double>& bound) const;

    /// Parts what the solvers call slip into slip and flow; `bound` is that of friction alone. Fills flow and yield
    /// stress of the solution, which are zero and that of the virgin layer outside contact.
    void divide(std::span<const double> bound, RollingSolution& solution) const;

   private:
    double yield_stress_behind(std::size_t i, double v, double bound, double diagonal, RollingSolution& solution) const;

    const ContactProblem& problem_;
    const InterfacialLayer& layer_;
    FlowTask task_;
};

}  // namespace contactd
