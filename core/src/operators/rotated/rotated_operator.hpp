// Represents rows of elements with different normals, on half-spaces along the loaded row.
#pragma once

#include <memory>

#include "contactd/influence_operator.hpp"
#include "operators/lazy.hpp"
#include "row_rotations.hpp"

namespace contactd {

/// Displacements are those of a flat surface, rotated from the axes of the loaded row to those of the observed one. The
/// matrices are not symmetric, unlike those of any elastic body, because the effects of two elements on each other
/// differ. Distances are those along the rows, as if these lay flat. The preconditioner, boxes and coarser grids are
/// those of the flat surface.
class RotatedOperator final : public InfluenceOperator {
   public:
    /// Throws InvalidArgument if the numbers of elements differ.
    RotatedOperator(std::shared_ptr<const InfluenceOperator> flat, RowRotations rotations);
    ~RotatedOperator() override;

    std::size_t size() const override { return flat_->size(); }
    void normal(std::span<const double> pz, std::span<double> uz) const override;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    bool coupled() const override { return true; }
    void normal_of_tangential(std::span<const double> px, std::span<const double> py,
                              std::span<double> uz) const override;
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override;
    bool is_symmetric() const override { return false; }
    std::vector<double> diagonal(Axis i) const override { return flat_->diagonal(i); }
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override {
        flat_->precondition(i, r, z);
    }
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override {
        flat_->precondition_tangential(rx, ry, zx, zy);
    }
    std::size_t bytes() const override { return flat_->bytes(); }
    const CoarserGrid* coarser() const override;
    const ElementBoxes* boxes() const override { return boxes_.get(); }

   private:
    class Boxes;
    RowComponents of_normal(std::span<const double> pz) const;
    RowComponents of_tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux) const;

    const std::shared_ptr<const InfluenceOperator> flat_;
    const RowRotations rotations_;
    std::unique_ptr<const ElementBoxes> boxes_;
    mutable Lazy<std::unique_ptr<const CoarserGrid>> coarser_;
};

}  // namespace contactd
