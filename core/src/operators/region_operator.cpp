#include "region_operator.hpp"

#include <algorithm>

namespace contactd {

class RegionOperator::Boxes final : public ElementBoxes {
   public:
    explicit Boxes(const RegionOperator& whole) : whole_(whole) {}

    ElementBox extent() const override { return of_bodies().extent(); }
    ElementBox convenient(const ElementBox& needed, bool may_grow) const override {
        return of_bodies().convenient(needed, may_grow);
    }
    std::shared_ptr<const InfluenceOperator> influence(const ElementBox& box) const override {
        const RegionShares& all = whole_.regions_;
        RegionShares part{{}, all.shares, all.count};
        part.region.reserve(box.size());
        for (int iy = 0; iy < box.ny; ++iy) {
            const auto row =
                all.region.begin() + static_cast<std::ptrdiff_t>(box.first_y + iy) * extent().nx + box.first_x;
            part.region.insert(part.region.end(), row, row + box.nx);
        }
        return std::make_shared<const RegionOperator>(of_bodies().influence(box), std::move(part));
    }

   private:
    const ElementBoxes& of_bodies() const { return *whole_.bodies_->boxes(); }
    const RegionOperator& whole_;
};

RegionOperator::RegionOperator(std::shared_ptr<const InfluenceOperator> bodies, RegionShares regions)
    : bodies_(std::move(bodies)), regions_(std::move(regions)) {
    if (bodies_->boxes() != nullptr) boxes_ = std::make_unique<Boxes>(*this);
}

RegionOperator::~RegionOperator() = default;

void RegionOperator::normal(std::span<const double> pz, std::span<double> uz) const {
    const auto count = static_cast<std::size_t>(regions_.count);
    std::vector<double> part(pz.size()), displacement(pz.size());
    std::fill(uz.begin(), uz.end(), 0.0);
    for (int j = -1; j < regions_.count; ++j) {
        bool is_loaded = false;
        for (std::size_t at = 0; at < part.size(); ++at) {
            part[at] = regions_.region[at] == j ? pz[at] : 0;
            is_loaded = is_loaded || part[at] != 0;
        }
        if (!is_loaded) continue;
        bodies_->normal(part, displacement);
        for (std::size_t at = 0; at < uz.size(); ++at) {
            const int i = regions_.region[at];
            const double share =
                i < 0 || j < 0 ? 1 : regions_.shares[static_cast<std::size_t>(i) * count + static_cast<std::size_t>(j)];
            uz[at] += share * displacement[at];
        }
    }
}

std::size_t RegionOperator::bytes() const {
    return bodies_->bytes() + regions_.region.size() * sizeof(int) + regions_.shares.size() * sizeof(double);
}

}  // namespace contactd
