#include "rotated_operator.hpp"

#include <utility>

#include "contactd/error.hpp"
#include "operators/coarser_with.hpp"

namespace contactd {

class RotatedOperator::Boxes final : public ElementBoxes {
   public:
    explicit Boxes(const RotatedOperator& whole) : whole_(whole) {}

    ElementBox extent() const override { return of_flat().extent(); }
    ElementBox convenient(const ElementBox& needed, bool may_grow) const override {
        return of_flat().convenient(needed, may_grow);
    }
    std::shared_ptr<const InfluenceOperator> influence(const ElementBox& box) const override {
        return std::make_shared<const RotatedOperator>(of_flat().influence(box),
                                                       whole_.rotations_.on(box.first_y, box.ny, box.nx));
    }

   private:
    const ElementBoxes& of_flat() const { return *whole_.flat_->boxes(); }

    const RotatedOperator& whole_;
};

RotatedOperator::RotatedOperator(std::shared_ptr<const InfluenceOperator> flat, RowRotations rotations)
    : flat_(std::move(flat)), rotations_(std::move(rotations)) {
    if (flat_->size() != rotations_.size()) throw InvalidArgument("flat", "has a different number of elements");
    if (flat_->boxes() != nullptr) boxes_ = std::make_unique<Boxes>(*this);
}

RotatedOperator::~RotatedOperator() = default;

RowComponents RotatedOperator::of_normal(std::span<const double> pz) const {
    RowComponents u(size());
    flat_->normal(pz, u.z);
    if (!flat_->coupled()) return u;
    std::vector<double> x(size());
    flat_->tangential_of_normal(pz, x, u.s);
    return u;
}

RowComponents RotatedOperator::of_tangential(std::span<const double> px, std::span<const double> py,
                                             std::span<double> ux) const {
    RowComponents u(size());
    flat_->tangential(px, py, ux, u.s);
    if (flat_->coupled()) flat_->normal_of_tangential(px, py, u.z);
    return u;
}

void RotatedOperator::normal(std::span<const double> pz, std::span<double> uz) const {
    rotations_.along_z(of_normal(rotations_.times_cosine(pz)), of_normal(rotations_.times_sine(pz)), uz);
}

void RotatedOperator::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                 std::span<double> uy) const {
    const RowComponents of_cosine = of_tangential(rotations_.times_cosine(px), rotations_.times_cosine(py), ux),
                        of_sine = of_tangential(rotations_.times_sine(px), rotations_.times_sine(py), ux);
    rotations_.along_s(of_cosine, of_sine, uy);
    of_tangential(px, py, ux);
}

void RotatedOperator::normal_of_tangential(std::span<const double> px, std::span<const double> py,
                                           std::span<double> uz) const {
    std::vector<double> x(size());
    const RowComponents of_cosine = of_tangential(rotations_.times_cosine(px), rotations_.times_cosine(py), x),
                        of_sine = of_tangential(rotations_.times_sine(px), rotations_.times_sine(py), x);
    rotations_.along_z(of_cosine, of_sine, uz);
}

void RotatedOperator::tangential_of_normal(std::span<const double> pz, std::span<double> ux,
                                           std::span<double> uy) const {
    rotations_.along_s(of_normal(rotations_.times_cosine(pz)), of_normal(rotations_.times_sine(pz)), uy);
    std::vector<double> s(size());
    flat_->tangential_of_normal(pz, ux, s);
}

const CoarserGrid* RotatedOperator::coarser() const {
    const auto make = [&]() -> std::unique_ptr<const CoarserGrid> {
        const CoarserGrid* grid = flat_->coarser();
        if (grid == nullptr) return nullptr;
        const std::shared_ptr<const InfluenceOperator> flat(std::shared_ptr<void>(),
                                                            &grid->influence());  // flat_ owns it
        return std::make_unique<const CoarserWith>(
            *grid, std::make_unique<const RotatedOperator>(flat, rotations_.coarse(grid->along_x(), grid->along_y())));
    };
    return coarser_.get(make).get();
}

}  // namespace contactd
