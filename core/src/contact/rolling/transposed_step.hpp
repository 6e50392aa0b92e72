// Computes products with the transpose of the increment over a step of rolling.
#pragma once

#include <span>

#include "contact/support/contact_elements.hpp"
#include "contactd/step_operator.hpp"
#include "reflection.hpp"

namespace contactd {

// The operator must outlive this object. Arrays have the size of its grid.
class TransposedStep {
   public:
    TransposedStep(const StepOperator& step, const Grid& grid, Reflection::Axes axes)
        : step_(step), reflection_(grid, axes), in_(grid.size()), out_(grid.size()) {}

    // Computes u = C^T p.
    void tangential(const Field& p, Field& u);
    // Computes C_xz^T p_x + C_yz^T p_y, the part of pressures. It requires a reflection at the centre.
    void pressures(const Field& p, std::span<double> result);
    bool has_pressures() const { return reflection_.at_centre(); }

   private:
    const StepOperator& step_;
    const Reflection reflection_;
    Field in_, out_;
};

}  // namespace contactd
