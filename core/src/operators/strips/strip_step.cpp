#include "strip_step.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "contactd/error.hpp"

namespace contactd {

StripStep::StripStep(std::shared_ptr<const StripParts> parts, const ElementBox& box, int ahead,
                     std::shared_ptr<const StepOperator> near)
    : increment_{std::move(parts), nullptr},
      box_(box),
      ahead_(ahead),
      coupled_(increment_.natural->coupled()),
      near_(std::move(near)),
      natural_(increment_.natural->on(box)) {
    if (const int reach = increment_.natural->reach(), nx = increment_.natural->extent().nx; std::abs(ahead_) > reach)
        throw InvalidArgument("ahead", "is " + std::to_string(ahead_) + " elements; the table contains " +
                                           std::to_string(nx + reach) + " offsets along x, and the grid has " +
                                           std::to_string(nx) + " elements");
}

StripStep::StripStep(StripIncrement change, const ElementBox& box, bool coupled,
                     std::shared_ptr<const StepOperator> near)
    : increment_(std::move(change)),
      box_(box),
      coupled_(coupled),
      near_(std::move(near)),
      natural_(increment_.natural->on(box)),
      opposite_(increment_.opposite->on(box)) {}

void StripStep::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                           std::span<double> uy) const {
    if (!opposite_) return natural_->tangential_change(ahead_, px, py, ux, uy);
    natural_->tangential(px, py, ux, uy);
    opposite_->add_tangential(px, py, ux, uy);
}

void StripStep::tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const {
    if (!coupled()) {
        std::fill(ux.begin(), ux.end(), 0.0);
        std::fill(uy.begin(), uy.end(), 0.0);
        return;
    }
    if (!opposite_) return natural_->tangential_change_of_normal(ahead_, pz, ux, uy);
    natural_->tangential_of_normal(pz, ux, uy);
    opposite_->add_tangential_of_normal(pz, ux, uy);
}

std::size_t StripStep::bytes() const {
    const std::size_t own = opposite_ ? increment_.natural->bytes() + increment_.opposite->bytes() : 0;
    return own + near_->bytes();
}

std::shared_ptr<const StepOperator> StripStep::on(const ElementBox& box) const {
    auto near = near_->on(box);
    if (!near) return nullptr;
    const ElementBox there{0, box_.first_y + box.first_y, box.nx, box.ny};
    if (!opposite_) return std::make_shared<const StripStep>(increment_.natural, there, ahead_, std::move(near));
    return std::make_shared<const StripStep>(increment_, there, coupled_, std::move(near));
}

}  // namespace contactd
