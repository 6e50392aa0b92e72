// Implements the parts of a frozen contact that only its transposed equations need.
#include <algorithm>
#include <cmath>
#include <utility>

#include "frozen_contact.hpp"

namespace contactd {

FrozenContact::Values FrozenContact::paste(const Values& box, std::size_t size) const {
    if (is_whole_) return box;
    Values whole(size);
    restriction_.paste(box, whole);
    return whole;
}

FrozenContact::Right FrozenContact::of_tractions(const Field& q) {
    rubbed_.gather(q.x, out_.x);
    rubbed_.gather(q.y, out_.y);
    Right right = right_of_slip();
    right.values = -right.values;
    return right;
}

Field FrozenContact::tractions_of(const Eigen::Ref<const Vector>& f) {
    Field y(grid_.size());
    if (tractions() == 0) return y;
    take_free(f);
    rubbed_.scatter(in_.x, y.x);
    rubbed_.scatter(in_.y, y.y);
    return y;
}

Field FrozenContact::transposed_slip(const Field& y) {
    q_ = y;
    find_slip();
    return s_;
}

FrozenContact::Values FrozenContact::transposed_coupling(const Field& y) {
    Values result(grid_.size());
    if (transposed_)
        transposed_->pressures(y, result);
    else
        influence_.normal_of_tangential(y.x, y.y, result);
    return result;
}

Field FrozenContact::slip_of_normal(const Values& l) const {
    Field s(grid_.size());
    influence_.tangential_of_normal(l, s.x, s.y);
    return s;
}

void FrozenContact::all_transposed(const Vector& both, Vector& result) {
    take_pressures(both.head(pressures()));
    influence_.normal(p_, u_);
    influence_.tangential_of_normal(p_, coupling_.x, coupling_.y);
    const Field y = tractions_of(both.tail(tractions()));
    const Field slip = transposed_slip(y);
    add(coupling_, slip);
    const Values pressed = transposed_coupling(y);
    for (std::size_t i = 0; i < u_.size(); ++i)
        u_[i] += pressed[i] + mu_[i] * (radial_.x[i] * coupling_.x[i] + radial_.y[i] * coupling_.y[i]);
    give_normal(result.data());
    rubbed_.gather(coupling_.x, out_.x);
    rubbed_.gather(coupling_.y, out_.y);
    result.tail(tractions()) = tangential_residual();
}

double FrozenContact::reciprocity_error(const Field& q, const Field& y, const Values& p) {
    const auto difference = [](double one, double other, double size) {
        return size > 0 ? std::abs(one - other) / size : 0;
    };
    const auto length = [](const Field& field) { return std::sqrt(inner(field, field)); };
    Field slip(grid_.size()), pressing(grid_.size());
    if (increment_ != nullptr)
        increment_->tangential(q.x, q.y, slip.x, slip.y);
    else
        influence_.tangential(q.x, q.y, slip.x, slip.y);
    const Field back = transposed_slip(y);
    const double error = difference(inner(slip, y), inner(q, back), length(slip) * length(y));
    if (!coupled_) return error;
    if (increment_ != nullptr)
        increment_->tangential_of_normal(p, pressing.x, pressing.y);
    else
        influence_.tangential_of_normal(p, pressing.x, pressing.y);
    const Values back_on_pressures = transposed_coupling(y);
    Values lifted(grid_.size());
    influence_.normal_of_tangential(q.x, q.y, lifted);
    const Field pressed = slip_of_normal(p);
    return std::max({error, difference(inner(pressing, y), dot(p, back_on_pressures), length(pressing) * length(y)),
                     difference(dot(lifted, p), inner(q, pressed), length(q) * length(pressed))});
}

}  // namespace contactd
