// Computes the increment over a step of rolling of two bodies whose tables are of different kinds.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "contactd/step_operator.hpp"
#include "lazy.hpp"
#include "sum_terms.hpp"

namespace contactd {

/// Signs and errors are those of SumOperator.
class SumStep final : public StepOperator {
   public:
    explicit SumStep(OfBodies<StepOperator> bodies);

    std::size_t size() const override { return size_; }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    bool coupled() const override;
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override;
    std::size_t bytes() const override;
    /// Returns the step on a box, or null if a body has none.
    std::shared_ptr<const StepOperator> on(const ElementBox& box) const override;
    const StepOperator* coarser() const override;

   private:
    struct Term {
        std::shared_ptr<const StepOperator> body;
        double coupling_sign;
    };
    std::size_t size_ = 0;
    std::vector<Term> terms_;
    mutable Lazy<std::unique_ptr<const StepOperator>> coarser_;
};

}  // namespace contactd
