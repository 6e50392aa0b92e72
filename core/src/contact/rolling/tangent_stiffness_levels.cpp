#include "tangent_stiffness_levels.hpp"

#include <utility>

#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

// They are in units of the diagonal of C, over which D has quantiles of 0.4, 1.5 and 5 (10, 50 and 90 % of the slip) on
// any grid.
constexpr std::array<double, 2> levels = {0.3, 2};
constexpr LevelPassages passages{0.63, 3.2, 1.5};

}  // namespace

std::unique_ptr<TangentStiffnessLevels> TangentStiffnessLevels::make(const StepOperator& increment,
                                                                     const Contact& contact, double unit) {
    Inverses inverses;
    for (std::size_t j = 0; j < count; ++j) {
        inverses[j] = increment.inverse(levels[j] * unit);
        if (!inverses[j]) return nullptr;
    }
    return std::unique_ptr<TangentStiffnessLevels>(
        new TangentStiffnessLevels(std::move(inverses), increment.size(), contact, unit));
}

TangentStiffnessLevels::TangentStiffnessLevels(Inverses inverses, std::size_t elements, const Contact& contact,
                                               double unit)
    : inverses_(std::move(inverses)),
      contact_(contact),
      unit_(unit),
      local_(contact.size()),
      full_in_(elements),
      full_out_(elements),
      sum_(contact.size()) {
    for (std::vector<double>& weight : weight_) weight.resize(contact.size());
}

void TangentStiffnessLevels::linearise(const Linearisation& linearisation) {
    weigh_levels(contact_.size(), passages, unit_, linearisation.tangent_stiffness.data(), weight_[0].data(),
                 weight_[1].data(), local_.data());
}

void TangentStiffnessLevels::solve_slip(const Linearisation& linearisation, const Field& r, Field& z) {
    const std::size_t m = contact_.size();
    multiply(m, local_.data(), r.x.data(), sum_.x.data());
    multiply(m, local_.data(), r.y.data(), sum_.y.data());
    for (std::size_t j = 0; j < count; ++j) {
        const double* weight = weight_[j].data();
        for (const auto& [first, grid_first, size] : contact_.runs) {
            multiply(size, weight + first, &r.x[first], &full_in_.x[grid_first]);
            multiply(size, weight + first, &r.y[first], &full_in_.y[grid_first]);
        }
        inverses_[j]->tangential(full_in_.x, full_in_.y, full_out_.x, full_out_.y);
        for (const auto& [first, grid_first, size] : contact_.runs) {
            add_product(size, weight + first, &full_out_.x[grid_first], &sum_.x[first]);
            add_product(size, weight + first, &full_out_.y[grid_first], &sum_.y[first]);
        }
    }
    linearisation.project(sum_);
    take_where(m, linearisation.slips.data(), sum_.x.data(), z.x.data());
    take_where(m, linearisation.slips.data(), sum_.y.data(), z.y.data());
}

}  // namespace contactd
