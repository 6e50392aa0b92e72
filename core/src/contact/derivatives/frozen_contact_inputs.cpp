// Computes right-hand sides of the equations by inputs, and the resulting forces.
#include <cmath>

#include "contact/rolling/rolling.hpp"
#include "frozen_contact.hpp"

namespace contactd {

double FrozenContact::mean_friction() const {
    double sum = 0;
    for (const std::size_t i : pressed_.elements) sum += mu_[i];
    return sum / static_cast<double>(pressed_.size());
}

// Makes the right-hand side from the slip in out_.
FrozenContact::Right FrozenContact::right_of_slip() const {
    double squares = 0;
    for (std::size_t e = 0; e < rubbed_.size(); ++e) {
        const double weight = weights_[static_cast<Eigen::Index>(e)];
        squares += weight * weight * (out_.x[e] * out_.x[e] + out_.y[e] * out_.y[e]);
    }
    return {-free_of(out_), std::sqrt(squares)};
}

void FrozenContact::take_rigid_slip(int direction) {
    for (std::size_t e = 0; e < rubbed_.size(); ++e) {
        const auto i = static_cast<int>(rubbed_.elements[e]);
        out_.x[e] = direction == 0 ? 1 : direction == 1 ? 0 : -grid_.y(i / grid_.nx);
        out_.y[e] = direction == 0 ? 0 : direction == 1 ? 1 : grid_.x(i % grid_.nx);
    }
}

FrozenContact::Right FrozenContact::of_slip(int direction) {
    take_rigid_slip(direction);
    return right_of_slip();
}

FrozenContact::Right FrozenContact::of_motion(int direction) {
    take_rigid_slip(direction);
    for (std::size_t e = 0; !entering_.empty() && e < rubbed_.size(); ++e) {
        const double part = entering_[rubbed_.elements[e]];
        out_.x[e] *= part;
        out_.y[e] *= part;
    }
    return right_of_slip();
}

FrozenContact::Right FrozenContact::of_bound(const Vector& dg) {
    take_bounds(dg);
    find_slip();
    rubbed_.gather(s_.x, out_.x);
    rubbed_.gather(s_.y, out_.y);
    return right_of_slip();
}

FrozenContact::Vector FrozenContact::pressures_of_bound(const Vector& dg) {
    take_bounds(dg);
    influence_.normal_of_tangential(q_.x, q_.y, u_);
    Vector right(pressures());
    give_normal(right.data());
    return -right;
}

FrozenContact::Vector FrozenContact::bound_of_friction() const {
    return Eigen::Map<const Vector>(pressed_.bound.data(), pressures());
}

FrozenContact::Vector FrozenContact::bound_of_pressure(const Vector& dp) const {
    Vector dg = dp;
    for (std::size_t e = 0; e < pressed_.size(); ++e) dg[static_cast<Eigen::Index>(e)] *= mu_[pressed_.elements[e]];
    return dg;
}

FrozenContact::Vector FrozenContact::weights_of_all() const {
    Vector weights(pressures() + tractions());
    weights << Vector::Ones(pressures()), weights_;
    return weights;
}

// A unit of rigid slip acts on the components whose sum is the force.
Eigen::MatrixXd FrozenContact::forces_of_tractions() {
    Eigen::MatrixXd forces(tractions(), 3);
    for (int k = 0; k < 3; ++k) forces.col(k) = -grid_.element_area() * of_slip(k).values;
    return forces;
}

Eigen::MatrixXd FrozenContact::forces_of_all() {
    Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(pressures() + tractions(), 4);
    const double area = grid_.element_area();
    for (Eigen::Index e = 0; e < pressures(); ++e) {
        const std::size_t i = pressed_.elements[static_cast<std::size_t>(e)];
        const double x = grid_.x(static_cast<int>(i) % grid_.nx), y = grid_.y(static_cast<int>(i) / grid_.nx);
        const double along_x = mu_[i] * radial_.x[i], along_y = mu_[i] * radial_.y[i];
        forces.row(e) << area, area * along_x, area * along_y, area * (x * along_y - y * along_x);
    }
    forces.bottomRightCorner(tractions(), 3) = forces_of_tractions();
    return forces;
}

FrozenContact::Forces FrozenContact::forces_of_bound(const Vector& dg) {
    take_bounds(dg);
    const TangentialForces sum = tangential_forces(grid_, q_.x, q_.y);
    return {sum.Fx, sum.Fy, sum.Mz};
}

}  // namespace contactd
