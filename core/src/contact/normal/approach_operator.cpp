#include "approach_operator.hpp"

#include <functional>
#include <utility>

#include "operators/coarser_with.hpp"

namespace contactd {

using Values = std::vector<double>;

namespace {

Values multiplied(std::span<const double> a, std::span<const double> b) {
    Values result(a.size());
    std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::multiplies<>());
    return result;
}

Values divided(std::span<const double> a, std::span<const double> b) {
    Values result(a.size());
    std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::divides<>());
    return result;
}

Values average_of(const CoarserGrid& grid, std::span<const double> fine) {
    Values coarse(grid.influence().size());
    grid.average(fine, coarse);
    return coarse;
}

}  // namespace

/// Holds the operator of the box that it represents.
class ApproachOperator::Part {
   public:
    Part(std::shared_ptr<const InfluenceOperator> inner, Values cosine)
        : inner_(std::move(inner)), influence_(*inner_, std::move(cosine)) {}

    const ApproachOperator& influence() const { return influence_; }

   private:
    const std::shared_ptr<const InfluenceOperator> inner_;
    const ApproachOperator influence_;
};

class ApproachOperator::Boxes final : public ElementBoxes {
   public:
    Boxes(const ElementBoxes& inner, std::span<const double> cosine) : inner_(inner), cosine_(cosine) {}

    ElementBox extent() const override { return inner_.extent(); }
    ElementBox convenient(const ElementBox& needed, bool may_grow) const override {
        return inner_.convenient(needed, may_grow);
    }
    std::shared_ptr<const InfluenceOperator> influence(const ElementBox& box) const override {
        Values cosine;
        for (int iy = box.first_y; iy < box.first_y + box.ny; ++iy) {
            const auto row = cosine_.begin() + static_cast<std::ptrdiff_t>(iy) * extent().nx + box.first_x;
            cosine.insert(cosine.end(), row, row + box.nx);
        }
        const auto part = std::make_shared<const Part>(inner_.influence(box), std::move(cosine));
        return {part, &part->influence()};
    }

   private:
    const ElementBoxes& inner_;
    const std::span<const double> cosine_;
};

ApproachOperator::ApproachOperator(const InfluenceOperator& inner, Values cosine)
    : inner_(inner), cosine_(std::move(cosine)) {
    if (inner_.boxes() != nullptr) boxes_ = std::make_unique<Boxes>(*inner_.boxes(), cosine_);
}

ApproachOperator::~ApproachOperator() = default;

Values ApproachOperator::times_cosine(Values values) const {
    return multiplied(values, cosine_);
}

Values ApproachOperator::over_cosine(Values values) const {
    return divided(values, cosine_);
}

void ApproachOperator::normal(std::span<const double> pz, std::span<double> uz) const {
    inner_.normal(divided(pz, cosine_), uz);
    std::transform(uz.begin(), uz.end(), cosine_.begin(), uz.begin(), std::divides<>());
}

void ApproachOperator::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                  std::span<double> uy) const {
    inner_.tangential(px, py, ux, uy);
}

Values ApproachOperator::diagonal(Axis i) const {
    return i == Axis::z ? divided(divided(inner_.diagonal(i), cosine_), cosine_) : inner_.diagonal(i);
}

void ApproachOperator::precondition(Axis i, std::span<const double> r, std::span<double> z) const {
    if (i != Axis::z) return inner_.precondition(i, r, z);
    inner_.precondition(i, multiplied(r, cosine_), z);
    std::transform(z.begin(), z.end(), cosine_.begin(), z.begin(), std::multiplies<>());
}

const CoarserGrid* ApproachOperator::coarser() const {
    const auto make = [&]() -> std::unique_ptr<const CoarserGrid> {
        const CoarserGrid* grid = inner_.coarser();
        if (grid == nullptr) return nullptr;
        auto averaged = std::make_unique<const ApproachOperator>(grid->influence(), average_of(*grid, cosine_));
        return std::make_unique<const CoarserWith>(*grid, std::move(averaged));
    };
    return coarser_.get(make).get();
}

}  // namespace contactd
