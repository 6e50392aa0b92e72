#include "thin_sheet.hpp"

#include <utility>

#include "coarser_with.hpp"

namespace contactd {

class ThinSheet::Boxes final : public ElementBoxes {
   public:
    explicit Boxes(const ThinSheet& whole) : whole_(whole) {}

    ElementBox extent() const override { return of_bodies().extent(); }
    ElementBox convenient(const ElementBox& needed, bool may_grow) const override {
        return of_bodies().convenient(needed, may_grow);
    }
    std::shared_ptr<const InfluenceOperator> influence(const ElementBox& box) const override {
        return std::make_shared<const ThinSheet>(of_bodies().influence(box), whole_.flexibility_);
    }

   private:
    const ElementBoxes& of_bodies() const { return *whole_.bodies_->boxes(); }
    const ThinSheet& whole_;
};

ThinSheet::ThinSheet(std::shared_ptr<const InfluenceOperator> bodies, double flexibility)
    : bodies_(std::move(bodies)), flexibility_(flexibility), share_(bodies_->diagonal(Axis::z)) {
    for (double& share : share_) share /= share + flexibility_;
    if (bodies_->boxes() != nullptr) boxes_ = std::make_unique<Boxes>(*this);
}

ThinSheet::~ThinSheet() = default;

void ThinSheet::normal(std::span<const double> pz, std::span<double> uz) const {
    bodies_->normal(pz, uz);
    for (std::size_t at = 0; at < uz.size(); ++at) uz[at] += flexibility_ * pz[at];
}

std::vector<double> ThinSheet::diagonal(Axis i) const {
    std::vector<double> values = bodies_->diagonal(i);
    if (i == Axis::z)
        for (double& value : values) value += flexibility_;
    return values;
}

void ThinSheet::precondition(Axis i, std::span<const double> r, std::span<double> z) const {
    if (i != Axis::z) {
        bodies_->precondition(i, r, z);
        return;
    }
    std::vector<double> weighted(r.size());
    for (std::size_t at = 0; at < r.size(); ++at) weighted[at] = share_[at] * r[at];
    bodies_->precondition(i, weighted, z);
    for (std::size_t at = 0; at < r.size(); ++at) {
        const double rest = 1 - share_[at];
        z[at] = share_[at] * z[at] + rest * rest * r[at] / flexibility_;
    }
}

const CoarserGrid* ThinSheet::coarser() const {
    return coarser_
        .get([&]() -> std::unique_ptr<const CoarserGrid> {
            const CoarserGrid* grid = bodies_->coarser();
            if (grid == nullptr) return nullptr;
            const std::shared_ptr<const InfluenceOperator> borrowed(std::shared_ptr<void>(), &grid->influence());
            return std::make_unique<CoarserWith>(*grid, std::make_unique<ThinSheet>(borrowed, flexibility_));
        })
        .get();
}

}  // namespace contactd
