// Tractions of both closed-form theories: Hertz-like over the ellipse, less Hertz-like over a similar, smaller one.
#pragma once

#include <array>
#include <cmath>

#include "closed_forms/dual.hpp"
#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/force_search.hpp"
#include "closed_forms/forces_by_motion.hpp"
#include "closed_forms/rolling_frame.hpp"

namespace contactd {

/// value k^n, multiplied from left to right.
template <class Number>
Number times_power(Number value, const Number& k, int n) {
    for (int i = 0; i < n; ++i) value = value * k;
    return value;
}

/// The n-th root, n being the force_power of a contact.
inline double root(double value, int n) {
    return n == 2 ? std::sqrt(value) : std::cbrt(value);
}

/// Direction of the force when all slips, |w/full| >= 1: the elastic displacement (or its gradient along the rolling
/// direction) is -full n, and the rest of the motion w slips, against the force. Joins w/full where slip becomes full.
/// w = -(lambda + full) n with |n| = 1, by Newton's method on 1/|n| - 1, which is nearly linear in lambda.
template <class Number>
std::array<Number, 2> direction_of_slip(const std::array<Number, 2>& w, const Pair& full) {
    using std::abs, std::hypot, std::sqrt;
    Number lambda = 0;
    std::array<Number, 2> n{};
    for (int iteration = 0; iteration < 50; ++iteration) {
        Number norm2 = 0, slope = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            const Number stiff = lambda + full[i];
            n[i] = -w[i] / stiff;
            norm2 += n[i] * n[i];
            slope += n[i] * n[i] / stiff;
        }
        const Number change = norm2 * (sqrt(norm2) - 1) / slope;
        lambda += change;
        if (abs(change) <= 1e-15 * lambda) break;
    }
    const Number norm = hypot(n[0], n[1]);
    return {n[0] / norm, n[1] / norm};
}

/// The direction of the force and how large the ellipse is that adheres, as of ellipse_difference.
template <class Number>
struct EllipseState {
    std::array<Number, 2> direction{};
    Number k = 1;

    /// `n` is the contact's force_power.
    std::array<Number, 2> force(double bound, int n) const {
        const Number size = bound * (1 - times_power(k, k, n - 1));
        return {size * direction[0], size * direction[1]};
    }
};

/// `direction` is the unit vector of the force (zero without one); the smaller ellipse, k times as large, adheres; its
/// centre lies (1-k) a ahead of the other's in rolling, so that they touch there, and at the same place in a shift.
EllipticFriction ellipse_difference(const Grid& grid, const EllipticContact& contact, double mu, const Pair& direction,
                                    double k, const RollingFrame* rolling);

}  // namespace contactd
