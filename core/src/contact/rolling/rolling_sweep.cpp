#include "rolling_sweep.hpp"

#include <algorithm>
#include <utility>

#include "contact/support/traction_loops.hpp"

namespace contactd {

RollingSweep::RollingSweep(const Grid& grid, double step_x, double step_y, const Contact& contact,
                           std::vector<double> stiffness)
    : m_(contact.size()),
      upstream_(grid, step_x, step_y, contact.elements),
      stiffness_(std::move(stiffness)),
      inverse_diagonal_(m_),
      z_(m_ + 1) {
    for (const double value : stiffness_) diagonal_stiffness_.push_back(upstream_.diagonal() * value);
}

void RollingSweep::linearise(const Linearisation& linearisation) {
    linearisation_ = &linearisation;
    shifted_reciprocal(m_, linearisation.tangent_stiffness.data(), diagonal_stiffness_.data(), stiffness_.data(),
                       inverse_diagonal_.data());
    // The traction of an element that flows follows the one ahead along its direction, as in adhesion.
    if (linearisation.flow) along_flow_.assign(m_, 1 / upstream_.diagonal());
    to_adhesion_ = up_to_last([&](std::size_t e) { return !linearisation.slips[e]; });
}

template <bool flows>
void RollingSweep::sweep(const Field& r, std::size_t count) const {
    const Linearisation& l = *linearisation_;
    const std::size_t links = upstream_.links();
    const std::vector<std::size_t>& order = upstream_.order();
    const Upstream::Link* link = upstream_.ahead().data();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t e = order[k];
        double x = r.x[e], y = r.y[e];
        for (std::size_t j = 0; j < links; ++j, ++link) {
            x += link->weight * z_.x[link->element];
            y += link->weight * z_.y[link->element];
        }
        const double nx = l.normal.x[e], ny = l.normal.y[e], along = x * nx + y * ny;
        x -= along * nx;
        y -= along * ny;
        if constexpr (flows) {
            const double fx = l.flow->direction.x[e], fy = l.flow->direction.y[e];
            const double more = (along_flow_[e] - inverse_diagonal_[e]) * (x * fx + y * fy);
            z_.x[e] = x * inverse_diagonal_[e] + more * fx;
            z_.y[e] = y * inverse_diagonal_[e] + more * fy;
        } else {
            z_.x[e] = x * inverse_diagonal_[e];
            z_.y[e] = y * inverse_diagonal_[e];
        }
    }
}

void RollingSweep::solve(const Field& r, Field& z, std::size_t count) const {
    if (linearisation_->flow)
        sweep<true>(r, count);
    else
        sweep<false>(r, count);
    std::copy(z_.x.begin(), z_.x.end() - 1, z.x.begin());
    std::copy(z_.y.begin(), z_.y.end() - 1, z.y.begin());
}

}  // namespace contactd
