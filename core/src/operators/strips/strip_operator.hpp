// Implements the influence operator of a strip table: FFTs along x, and a real symmetric matrix across the section for
// each wavenumber.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "contactd/influence_operator.hpp"
#include "operators/lazy.hpp"
#include "strip_parts.hpp"

namespace contactd {

/// A periodic symbol of a body that is clamped far away is not positive. Therefore the preconditioner is that of other
/// bodies: half-spaces near the surface of this one. It has coarser grids and boxes if these have them.
class StripOperator final : public InfluenceOperator {
   public:
    /// Creates the operator on the elements of `box`, which lies on the grid of `parts`. `near` has the same number of
    /// elements.
    StripOperator(std::shared_ptr<const StripParts> parts, const ElementBox& box,
                  std::shared_ptr<const InfluenceOperator> near);
    ~StripOperator() override;

    std::size_t size() const override { return box_.size(); }
    void normal(std::span<const double> pz, std::span<double> uz) const override;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    bool coupled() const override { return parts_->coupled(); }
    void normal_of_tangential(std::span<const double> px, std::span<const double> py,
                              std::span<double> uz) const override;
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override;
    std::vector<double> diagonal(Axis i) const override;
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override;
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override;
    std::size_t bytes() const override { return parts_->bytes() + near_->bytes(); }
    const CoarserGrid* coarser() const override;
    const ElementBoxes* boxes() const override { return boxes_.get(); }

   private:
    class Boxes;
    const std::shared_ptr<const StripParts> parts_;
    const ElementBox box_;
    const std::shared_ptr<const InfluenceOperator> near_;
    const std::shared_ptr<const StripProducts> products_;
    std::unique_ptr<const ElementBoxes> boxes_;
    mutable Lazy<std::unique_ptr<const CoarserGrid>> coarser_;
};

}  // namespace contactd
