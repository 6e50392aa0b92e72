// Represents a thin sheet between two bodies, which deforms only where it is loaded (Winkler's foundation).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "contactd/influence_operator.hpp"
#include "operators/lazy.hpp"

namespace contactd {

/// Holds the flexibilities under pressure and under tangential tractions (mm^3/N), >= 0.
struct SheetFlexibility {
    double normal = 0, tangential = 0;

    double along(Axis i) const { return i == Axis::z ? normal : tangential; }
};

/// Implements the operator of the bodies and of the sheet: A_ii + flexibility. It has coarser grids and boxes if that
/// of the bodies has them.
class ThinSheet final : public InfluenceOperator {
   public:
    ThinSheet(std::shared_ptr<const InfluenceOperator> bodies, const SheetFlexibility& flexibility);
    ~ThinSheet() override;

    std::size_t size() const override { return bodies_->size(); }
    void normal(std::span<const double> pz, std::span<double> uz) const override;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    bool coupled() const override { return bodies_->coupled(); }
    bool is_symmetric() const override { return bodies_->is_symmetric(); }
    void normal_of_tangential(std::span<const double> px, std::span<const double> py,
                              std::span<double> uz) const override {
        bodies_->normal_of_tangential(px, py, uz);
    }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override {
        bodies_->tangential_of_normal(pz, ux, uy);
    }
    std::vector<double> diagonal(Axis i) const override;
    /// Computes z = W M W r + (1 - W)^2 r / flexibility, with W the part of the bodies in the diagonal. It is exact if
    /// one of both dominates, and always symmetric and positive definite.
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override;
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override;
    std::size_t bytes() const override;
    const CoarserGrid* coarser() const override;
    const ElementBoxes* boxes() const override { return boxes_.get(); }

   private:
    class Boxes;
    std::vector<double> weighted(Axis i, std::span<const double> r) const;
    void complete(Axis i, std::span<const double> r, std::span<double> z) const;

    std::shared_ptr<const InfluenceOperator> bodies_;
    SheetFlexibility flexibility_;
    std::vector<double> share_x_, share_y_, share_z_;  // W; empty if the sheet does not deform
    const std::vector<double>& share(Axis i) const {
        return i == Axis::x ? share_x_ : i == Axis::y ? share_y_ : share_z_;
    }
    mutable Lazy<std::unique_ptr<const CoarserGrid>> coarser_;
    std::unique_ptr<const ElementBoxes> boxes_;
};

}  // namespace contactd
