// Computes plastic flow in a layer between the bodies: the state carried by particles, and the plastic part of the
// relative motion.
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
    /// `problem` has a layer that yields, and must outlive this object.
    explicit LayerFlow(const ContactProblem& problem);

    /// Begins a new step. `yield_stress` is that at the end of the previous step, shape [ny, nx] (N/mm^2); if it is
    /// empty, no particle has flowed.
    void begin(const std::vector<double>& yield_stress);

    /// Returns the task for solvers if the layer hardens or softens, otherwise null.
    const FlowTask* task() const { return layer_.hardens() ? &task_ : nullptr; }
    /// Limits the friction bound (N/mm^2) to the yield stress of the layer if that is constant.
    void limit(std::vector<double>& bound) const;

    /// Divides the slip of the solvers into slip and flow; `bound` is that of friction alone. Sets flow and yield
    /// stress of the solution; outside the contact these are zero and that of the virgin layer.
    void divide(std::span<const double> bound, RollingSolution& solution) const;

   private:
    double yield_stress_behind(std::size_t i, double v, double bound, double diagonal, RollingSolution& solution) const;

    const ContactProblem& problem_;
    const InterfacialLayer& layer_;
    FlowTask task_;
};

}  // namespace contactd
