#include "strip_operator.hpp"

#include <utility>

#include "contactd/error.hpp"
#include "operators/cached_boxes.hpp"
#include "operators/coarser_with.hpp"

namespace contactd {

class StripOperator::Boxes final : public ElementBoxes {
   public:
    explicit Boxes(const StripOperator& whole) : whole_(whole) {}

    ElementBox extent() const override { return {0, 0, whole_.box_.nx, whole_.box_.ny}; }
    ElementBox convenient(const ElementBox& needed, bool may_grow) const override {
        return whole_.near_->boxes()->convenient(needed, may_grow);
    }
    std::shared_ptr<const InfluenceOperator> influence(const ElementBox& box) const override {
        const ElementBox there{0, whole_.box_.first_y + box.first_y, box.nx, box.ny};
        return cache_.get(there, [&] {
            return std::make_shared<const StripOperator>(whole_.parts_, there, whole_.near_->boxes()->influence(box));
        });
    }

   private:
    const StripOperator& whole_;
    mutable CachedBoxes<InfluenceOperator> cache_;
};

StripOperator::StripOperator(std::shared_ptr<const StripParts> parts, const ElementBox& box,
                             std::shared_ptr<const InfluenceOperator> near)
    : parts_(std::move(parts)), box_(box), near_(std::move(near)), products_(parts_->on(box)) {
    if (near_->size() != box_.size()) throw InvalidArgument("near", "has a different number of elements");
    if (near_->boxes() != nullptr) boxes_ = std::make_unique<Boxes>(*this);
}

StripOperator::~StripOperator() = default;

void StripOperator::normal(std::span<const double> pz, std::span<double> uz) const {
    products_->normal(pz, uz);
}

void StripOperator::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                               std::span<double> uy) const {
    products_->tangential(px, py, ux, uy);
}

void StripOperator::normal_of_tangential(std::span<const double> px, std::span<const double> py,
                                         std::span<double> uz) const {
    if (!coupled()) return InfluenceOperator::normal_of_tangential(px, py, uz);
    products_->normal_of_tangential(px, py, uz);
}

void StripOperator::tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const {
    if (!coupled()) return InfluenceOperator::tangential_of_normal(pz, ux, uy);
    products_->tangential_of_normal(pz, ux, uy);
}

std::vector<double> StripOperator::diagonal(Axis i) const {
    std::vector<double> values;
    values.reserve(size());
    for (int strip = box_.first_y; strip < box_.first_y + box_.ny; ++strip)
        values.insert(values.end(), static_cast<std::size_t>(box_.nx), parts_->self(i, strip));
    return values;
}

void StripOperator::precondition(Axis i, std::span<const double> r, std::span<double> z) const {
    near_->precondition(i, r, z);
}

void StripOperator::precondition_tangential(std::span<const double> rx, std::span<const double> ry,
                                            std::span<double> zx, std::span<double> zy) const {
    near_->precondition_tangential(rx, ry, zx, zy);
}

const CoarserGrid* StripOperator::coarser() const {
    const auto make = [&]() -> std::unique_ptr<const CoarserGrid> {
        const CoarserGrid* grid = near_->coarser();
        if (grid == nullptr) return nullptr;
        const auto parts = parts_->coarse(box_, grid->along_x(), grid->along_y());
        const std::shared_ptr<const InfluenceOperator> near(std::shared_ptr<void>(),
                                                            &grid->influence());  // near_ owns it
        return std::make_unique<const CoarserWith>(*grid,
                                                   std::make_unique<const StripOperator>(parts, parts->extent(), near));
    };
    return coarser_.get(make).get();
}

}  // namespace contactd
