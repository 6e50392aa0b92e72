#include "thin_sheet.hpp"

#include <utility>

#include "operators/coarser_with.hpp"

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

ThinSheet::ThinSheet(std::shared_ptr<const InfluenceOperator> bodies, const SheetFlexibility& flexibility)
    : bodies_(std::move(bodies)), flexibility_(flexibility) {
    const auto share_of_bodies = [this](Axis i) {
        std::vector<double> share;
        if (!(flexibility_.along(i) > 0)) return share;
        share = bodies_->diagonal(i);
        for (double& value : share) value /= value + flexibility_.along(i);
        return share;
    };
    share_x_ = share_of_bodies(Axis::x);
    share_y_ = share_of_bodies(Axis::y);
    share_z_ = share_of_bodies(Axis::z);
    if (bodies_->boxes() != nullptr) boxes_ = std::make_unique<Boxes>(*this);
}

ThinSheet::~ThinSheet() = default;

void ThinSheet::normal(std::span<const double> pz, std::span<double> uz) const {
    bodies_->normal(pz, uz);
    for (std::size_t at = 0; at < uz.size(); ++at) uz[at] += flexibility_.normal * pz[at];
}

void ThinSheet::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                           std::span<double> uy) const {
    bodies_->tangential(px, py, ux, uy);
    for (std::size_t at = 0; at < ux.size(); ++at) {
        ux[at] += flexibility_.tangential * px[at];
        uy[at] += flexibility_.tangential * py[at];
    }
}

std::vector<double> ThinSheet::diagonal(Axis i) const {
    std::vector<double> values = bodies_->diagonal(i);
    for (double& value : values) value += flexibility_.along(i);
    return values;
}

// Returns W r.
std::vector<double> ThinSheet::weighted(Axis i, std::span<const double> r) const {
    std::vector<double> values(r.begin(), r.end());
    const std::vector<double>& bodies = share(i);
    for (std::size_t at = 0; at < bodies.size(); ++at) values[at] *= bodies[at];
    return values;
}

// Converts M W r, in z, to the result of the whole preconditioner for r.
void ThinSheet::complete(Axis i, std::span<const double> r, std::span<double> z) const {
    const std::vector<double>& bodies = share(i);
    if (bodies.empty()) return;
    const double stiffness = 1 / flexibility_.along(i);
    for (std::size_t at = 0; at < bodies.size(); ++at) {
        const double rest = 1 - bodies[at];
        z[at] = bodies[at] * z[at] + stiffness * rest * rest * r[at];
    }
}

void ThinSheet::precondition(Axis i, std::span<const double> r, std::span<double> z) const {
    bodies_->precondition(i, weighted(i, r), z);
    complete(i, r, z);
}

void ThinSheet::precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                        std::span<double> zy) const {
    if (share_x_.empty()) return bodies_->precondition_tangential(rx, ry, zx, zy);
    bodies_->precondition_tangential(weighted(Axis::x, rx), weighted(Axis::y, ry), zx, zy);
    complete(Axis::x, rx, zx);
    complete(Axis::y, ry, zy);
}

std::size_t ThinSheet::bytes() const {
    return bodies_->bytes() + (share_x_.size() + share_y_.size() + share_z_.size()) * sizeof(double);
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
