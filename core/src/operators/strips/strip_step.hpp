// The increment of displacements over a step of rolling along x, by strip tables.
#pragma once

#include <cstddef>
#include <memory>

#include "contactd/step_operator.hpp"
#include "strip_parts.hpp"

namespace contactd {

/// C[i,j](I,J,k) for offsets of both signs as a sum: what of it has the parity of a strip table and what has the
/// opposite one, the tangential displacements of both.
struct StripIncrement {
    std::shared_ptr<const StripParts> natural, opposite;
};

/// A step by whole elements has the products of the influence operator, read at two places; any other step has a table
/// of its own. Inverses and the coarser grid, where first estimates are found, are those of half-spaces.
class StripStep final : public StepOperator {
   public:
    /// On the elements of `box`, as StripOperator; `ahead` elements along x, for which the table has the offsets.
    /// `near`: of half-spaces and the same step. Throws InvalidArgument ("ahead") beyond the table.
    StripStep(std::shared_ptr<const StripParts> parts, const ElementBox& box, int ahead,
              std::shared_ptr<const StepOperator> near);
    /// Makes the increment of any step. `coupled` is as for the influence operator.
    StripStep(StripIncrement change, const ElementBox& box, bool coupled, std::shared_ptr<const StepOperator> near);

    std::size_t size() const override { return box_.size(); }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    bool coupled() const override { return coupled_; }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override;
    /// Symbols of the influence operator do not count.
    std::size_t bytes() const override;
    std::shared_ptr<const StepInverse> inverse(double added) const override { return near_->inverse(added); }
    std::shared_ptr<const StepOperator> on(const ElementBox& box) const override;
    const StepOperator* coarser() const override { return near_->coarser(); }

   private:
    const StripIncrement increment_;  // of a step by whole elements the influence operator's, and no opposite
    const ElementBox box_;
    const int ahead_ = 0;
    const bool coupled_;
    const std::shared_ptr<const StepOperator> near_;
    const std::shared_ptr<const StripProducts> natural_, opposite_;
};

}  // namespace contactd
