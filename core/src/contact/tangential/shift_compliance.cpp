#include "shift_compliance.hpp"

#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

// A and D have equal weight at a tangent stiffness of this number times the self-influence, as in TangCg.
constexpr double soft = 3;
constexpr double close_by = 1.5;  // times the self-influence: that of an element with its close neighbours

}  // namespace

ShiftCompliance::ShiftCompliance(const InfluenceOperator& influence, const Contact& contact)
    : influence_(influence),
      contact_(contact),
      self_(tangential_diagonal(influence, contact)),
      scale_(contact.size()),
      diagonal_(contact.size()),
      along_flow_(self_, soft, close_by),
      full_in_(influence.size()),
      full_out_(influence.size()) {}

void ShiftCompliance::apply(const Field& p, Field& u) {
    contact_.product(influence_, p, full_in_, full_out_, u);
}

void ShiftCompliance::linearise(const Linearisation& law) {
    law_ = &law;
    for (std::size_t e = 0; e < self_.size(); ++e) {
        const double added = 1 / (soft * self_[e] + law.tangent_stiffness[e]);
        scale_[e] = soft * self_[e] * added;
        diagonal_[e] = (1 - scale_[e] * scale_[e]) * added;
    }
    if (!law.flow) return;
    along_flow_.linearise(*law.flow);
    if (rows_.x.empty()) rows_ = Field(contact_.size());
}

void ShiftCompliance::precondition(const Field& r, Field& z, Residual, int) {
    if (law_->flow) {
        along_flow_.scale_rows(scale_, r, rows_);
        contact_.scatter(rows_.x, full_in_.x);
        contact_.scatter(rows_.y, full_in_.y);
        influence_.precondition_tangential(full_in_.x, full_in_.y, full_out_.x, full_out_.y);
        contact_.gather(full_out_.x, z.x);
        contact_.gather(full_out_.y, z.y);
        along_flow_.complete(scale_, diagonal_, r, z);
        law_->project(z);
        return;
    }
    for (const Contact::Run& run : contact_.runs) {
        multiply(run.size, &scale_[run.first], &r.x[run.first], &full_in_.x[run.grid_first]);
        multiply(run.size, &scale_[run.first], &r.y[run.first], &full_in_.y[run.grid_first]);
    }
    influence_.precondition_tangential(full_in_.x, full_in_.y, full_out_.x, full_out_.y);
    contact_.gather(full_out_.x, z.x);
    contact_.gather(full_out_.y, z.y);
    combine(self_.size(), scale_.data(), diagonal_.data(), r, law_->normal, z);
}

}  // namespace contactd
