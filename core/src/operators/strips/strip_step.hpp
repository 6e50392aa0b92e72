// Computes the increment of displacements over a step of rolling along x, by strip tables.
#pragma once

#include <cstddef>
#include <memory>

#include "contactd/step_operator.hpp"
#include "strip_parts.hpp"

namespace contactd {

/// Holds C[i,j](I,J,k) for offsets of both signs as a sum of a part with the parity of a strip table and a part with
/// the opposite one, for the tangential displacements.
struct StripIncrement {
    std::shared_ptr<const StripParts> natural, opposite;
};

/// A step by whole elements uses the products of the influence operator, read at two places; any other step has its own
/// table. Inverses and the coarser grid for first estimates are those of half-spaces.
class StripStep final : public StepOperator {
   public:
    /// Creates the step on the elements of `box`, as in StripOperator; `ahead` elements along x, for which the table
    /// has the offsets. `near` is for half-spaces and the same step. Throws InvalidArgument ("ahead") beyond the table.
    StripStep(std::shared_ptr<const StripParts> parts, const ElementBox& box, int ahead,
              std::shared_ptr<const StepOperator> near);
    /// Makes the increment of any step. `coupled` is as for the influence operator.
    StripStep(StripIncrement change, const ElementBox& box, bool coupled, std::shared_ptr<const StepOperator> near);

    std::size_t size() const override { return box_.size(); }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    bool coupled() const override { return coupled_; }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override;
    /// Returns the memory without symbols of the influence operator.
    std::size_t bytes() const override;
    std::shared_ptr<const StepInverse> inverse(double added) const override { return near_->inverse(added); }
    std::shared_ptr<const StepOperator> on(const ElementBox& box) const override;
    const StepOperator* coarser() const override { return near_->coarser(); }

   private:
    // For a step by whole elements, it is that of the influence operator, without an opposite part.
    const StripIncrement increment_;
    const ElementBox box_;
    const int ahead_ = 0;
    const bool coupled_;
    const std::shared_ptr<const StepOperator> near_;
    const std::shared_ptr<const StripProducts> natural_, opposite_;
};

}  // namespace contactd
