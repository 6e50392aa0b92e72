#include "sum_operator.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "coarser_with.hpp"

namespace contactd {

using namespace sums;

class SumOperator::Boxes final : public ElementBoxes {
   public:
    explicit Boxes(const SumOperator& whole) : whole_(whole) {}

    ElementBox extent() const override { return whole_.first().body->boxes()->extent(); }
    ElementBox convenient(const ElementBox& needed, bool may_grow) const override {
        return whole_.first().body->boxes()->convenient(needed, may_grow);
    }
    std::shared_ptr<const InfluenceOperator> influence(const ElementBox& box) const override {
        return std::make_shared<const SumOperator>(each<InfluenceOperator>(
            whole_.terms_, [&](const InfluenceOperator& body) { return body.boxes()->influence(box); }));
    }

   private:
    const SumOperator& whole_;
};

SumOperator::SumOperator(OfBodies<InfluenceOperator> bodies) : terms_(terms_of<Term>(bodies)) {
    size_ = first().body->size();
    for (const Axis i : {Axis::x, Axis::y, Axis::z}) {
        const std::vector<double> all = diagonal(i);
        for (Term& term : terms_) {
            std::vector<double>& share = term.share[static_cast<std::size_t>(i)];
            share = term.body->diagonal(i);
            for (std::size_t at = 0; at < size_; ++at) share[at] /= all[at];
        }
    }
    const auto same_extent = [&](const Term& term) {
        const ElementBoxes* boxes = term.body->boxes();
        return boxes != nullptr && boxes->extent() == extent_of(*first().body);
    };
    if (std::all_of(terms_.begin(), terms_.end(), same_extent)) boxes_ = std::make_unique<Boxes>(*this);
}

SumOperator::~SumOperator() = default;

void SumOperator::normal(std::span<const double> pz, std::span<double> uz) const {
    sum(terms_, uz, plain, [&](const Term& term, auto u) { term.body->normal(pz, u); });
}

void SumOperator::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                             std::span<double> uy) const {
    sum(terms_, ux, uy, plain, [&](const Term& term, auto x, auto y) { term.body->tangential(px, py, x, y); });
}

bool SumOperator::coupled() const {
    return any_coupled(terms_);
}

void SumOperator::normal_of_tangential(std::span<const double> px, std::span<const double> py,
                                       std::span<double> uz) const {
    sum(terms_, uz, coupling, [&](const Term& term, auto u) { term.body->normal_of_tangential(px, py, u); });
}

void SumOperator::tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const {
    sum(terms_, ux, uy, coupling, [&](const Term& term, auto x, auto y) { term.body->tangential_of_normal(pz, x, y); });
}

std::vector<double> SumOperator::diagonal(Axis i) const {
    std::vector<double> values(size_);
    for (const Term& term : terms_) add(term.body->diagonal(i), values);
    return values;
}

void SumOperator::precondition(Axis i, std::span<const double> r, std::span<double> z) const {
    std::vector<double> weighted(size_);
    sum(terms_, z, plain, [&](const Term& term, auto part) {
        const std::vector<double>& share = term.share[static_cast<std::size_t>(i)];
        std::transform(r.begin(), r.end(), share.begin(), weighted.begin(), std::multiplies<>());
        term.body->precondition(i, weighted, part);
        std::transform(part.begin(), part.end(), share.begin(), part.begin(), std::multiplies<>());
    });
}

void SumOperator::precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                          std::span<double> zy) const {
    std::vector<double> wx(size_), wy(size_);
    sum(terms_, zx, zy, plain, [&](const Term& term, auto x, auto y) {
        const auto& [share_x, share_y, share_z] = term.share;
        std::transform(rx.begin(), rx.end(), share_x.begin(), wx.begin(), std::multiplies<>());
        std::transform(ry.begin(), ry.end(), share_y.begin(), wy.begin(), std::multiplies<>());
        term.body->precondition_tangential(wx, wy, x, y);
        std::transform(x.begin(), x.end(), share_x.begin(), x.begin(), std::multiplies<>());
        std::transform(y.begin(), y.end(), share_y.begin(), y.begin(), std::multiplies<>());
    });
}

std::size_t SumOperator::bytes() const {
    std::size_t bytes = 3 * terms_.size() * size_ * sizeof(double);
    for (const Term& term : terms_) bytes += term.body->bytes();
    return bytes;
}

const CoarserGrid* SumOperator::coarser() const {
    const auto make = [&]() -> std::unique_ptr<const CoarserGrid> {
        const CoarserGrid* grid = first().body->coarser();
        const auto bodies = each<InfluenceOperator>(terms_, [&](const InfluenceOperator& body) {
            const CoarserGrid* coarser = body.coarser();
            const bool same = grid != nullptr && coarser != nullptr && coarser->along_x() == grid->along_x() &&
                              coarser->along_y() == grid->along_y();
            return borrowed(same ? &coarser->influence() : nullptr);
        });
        return none(bodies) ? nullptr
                            : std::make_unique<const CoarserWith>(*grid, std::make_unique<const SumOperator>(bodies));
    };
    return coarser_.get(make).get();
}

const ElementBoxes* SumOperator::boxes() const {
    return boxes_.get();
}

}  // namespace contactd
