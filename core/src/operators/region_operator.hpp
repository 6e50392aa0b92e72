// Represents bodies whose regions interact partially by the normal displacements of their pressures.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contactd/influence_operator.hpp"

namespace contactd {

/// Holds the regions of elements by the limits of ContactRegions.
struct RegionShares {
    std::vector<int> region;     ///< of each element; -1: none
    std::vector<double> shares;  ///< of ContactRegions, [count, count]
    int count = 0;
};

/// Computes uz = the sum over regions j of share(i, j) A_zz (pz in j), for elements in i; elements in no region have
/// the full displacements. A product requires one product of the bodies for each region under pressure. Other products
/// are those of the bodies. There is no coarser grid, because its elements would belong to several regions.
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
