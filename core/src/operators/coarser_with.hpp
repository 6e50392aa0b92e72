// Defines another operator on an existing coarser grid.
#pragma once

#include <memory>
#include <span>
#include <utility>

#include "contactd/influence_operator.hpp"

namespace contactd {

/// Averages and interpolates as `grid` does, which must outlive this object.
class CoarserWith final : public CoarserGrid {
   public:
    CoarserWith(const CoarserGrid& grid, std::unique_ptr<const InfluenceOperator> influence)
        : grid_(grid), influence_(std::move(influence)) {}

    const InfluenceOperator& influence() const override { return *influence_; }
    int along_x() const override { return grid_.along_x(); }
    int along_y() const override { return grid_.along_y(); }
    void average(std::span<const double> fine, std::span<double> coarse) const override { grid_.average(fine, coarse); }
    void interpolate(std::span<const double> coarse, std::span<double> fine) const override {
        grid_.interpolate(coarse, fine);
    }
    void copy(std::span<const double> coarse, std::span<double> fine) const override { grid_.copy(coarse, fine); }

   private:
    const CoarserGrid& grid_;
    const std::unique_ptr<const InfluenceOperator> influence_;
};

}  // namespace contactd
