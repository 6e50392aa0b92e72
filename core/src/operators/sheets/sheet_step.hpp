// Adds a thin sheet that shears to the increment of displacements over a step of rolling.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "contactd/grid.hpp"
#include "contactd/step_operator.hpp"
#include "operators/lazy.hpp"
#include "operators/upstream.hpp"

namespace contactd {

/// Implements C + flexibility (1 - S), where S p are the tractions one step ahead by bilinear interpolation between
/// centres, zero beyond the grid: particles carry the shear of the sheet.
class SheetStep final : public StepOperator {
   public:
    /// The step (step_x, step_y) is in mm, the flexibility in mm^3/N.
    SheetStep(std::shared_ptr<const StepOperator> bodies, const Grid& grid, double step_x, double step_y,
              double flexibility);

    std::size_t size() const override { return bodies_->size(); }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    bool coupled() const override { return bodies_->coupled(); }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override {
        bodies_->tangential_of_normal(pz, ux, uy);
    }
    std::size_t bytes() const override { return bodies_->bytes(); }
    std::shared_ptr<const StepOperator> on(const ElementBox& box) const override;
    const StepOperator* coarser() const override;

   private:
    void add_sheet(std::span<const double> p, std::span<double> u) const;

    std::shared_ptr<const StepOperator> bodies_;
    Grid grid_;
    double step_x_, step_y_, flexibility_;
    std::vector<ElementAhead> neighbours_;
    mutable Lazy<std::unique_ptr<const StepOperator>> coarser_;
};

}  // namespace contactd
