// Bodies whose regions feel the normal displacements by each other's pressures in part.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contactd/influence_operator.hpp"

namespace contactd {

/// Regions of elements, as ContactRegions has them by their limits.
struct RegionShares {
    std::vector<int> region;     ///< of each element; -1: none
    std::vector<double> shares;  ///< of ContactRegions, [count, count]
    int count = 0;
};

/// uz = the sum over regions j of share(i, j) A_zz (pz in j), for elements in i; those of none feel all. A product
/// takes as many of those of the bodies as there are regions under pressure. All else is that of the bodies. It has no
/// coarser grid: elements there would belong to several regions.
class RegionOperator final : public InfluenceOperator {
   public:
    RegionOperator(std::shared_ptr<const InfluenceOperator> bodies, RegionShares regions);
    ~RegionOperator() override;

    std::size_t size() const override { return bodies_->size(); }
    void normal(std::span<const double> pz, std::span<double> uz) const override;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override {
        bodies_->tangential(px, py, ux, uy);
    }
    bool coupled() const override { return bodies_->coupled(); }
    void normal_of_tangential(std::span<const double> px, std::span<const double> py,
                              std::span<double> uz) const override {
        bodies_->normal_of_tangential(px, py, uz);
    }
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const override {
        bodies_->tangential_of_normal(pz, ux, uy);
    }
    bool is_symmetric() const override { return bodies_->is_symmetric(); }
    std::vector<double> diagonal(Axis i) const override { return bodies_->diagonal(i); }
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override {
        bodies_->precondition(i, r, z);
    }
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override {
        bodies_->precondition_tangential(rx, ry, zx, zy);
    }
    std::size_t bytes() const override;
    const ElementBoxes* boxes() const override { return boxes_.get(); }

   private:
    class Boxes;

    std::shared_ptr<const InfluenceOperator> bodies_;
    RegionShares regions_;
    std::unique_ptr<const ElementBoxes> boxes_;
};

}  // namespace contactd
