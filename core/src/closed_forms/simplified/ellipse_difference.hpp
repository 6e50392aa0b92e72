// Computes the tractions of both closed-form theories: Hertz-like over the ellipse, minus Hertz-like over a similar,
// smaller one.
#pragma once

#include <array>
#include <cmath>

#include "closed_forms/dual.hpp"
#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/force_search.hpp"
#include "closed_forms/forces_by_motion.hpp"
#include "closed_forms/rolling_frame.hpp"

namespace contactd {

/// Returns value k^n, multiplied from left to right.
template <class Number>
Number times_power(Number value, const Number& k, int n) {
    for (int i = 0; i < n; ++i) value = value * k;
    return value;
}

/// Returns the n-th root, with n the force_power of a contact.
inline double root(double value, int n) {
    return n == 2 ? std::sqrt(value) : std::cbrt(value);
}

/// Returns the direction of the force in full slip, |w/full| >= 1. The elastic displacement (or its gradient along the
/// rolling direction) is -full n, and the rest of the motion w slips, against the force. The direction is continuous
/// with w/full at the start of full slip. w = -(lambda + full) n with |n| = 1 is solved by Newton's method on 1/|n| -
/// 1, which is nearly linear in lambda.
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

/// Holds the direction of the force and the size of the ellipse that adheres, as for ellipse_difference.
template <class Number>
struct EllipseState {
    std::array<Number, 2> direction{};
    Number k = 1;

    /// Returns the force; `n` is the contact's force_power.
    std::array<Number, 2> force(double bound, int n) const {
        const Number size = bound * (1 - times_power(k, k, n - 1));
        return {size * direction[0], size * direction[1]};
    }
};

/// Returns the tractions. `direction` is the unit vector of the force (zero without one). The smaller ellipse, k times
/// as large, adheres. In rolling, its centre lies (1-k) a ahead of the other's, so that they touch at the leading edge;
/// in a shift, both centres coincide.
EllipticFriction ellipse_difference(const Grid& grid, const EllipticContact& contact, double mu, const Pair& direction,
                                    double k, const RollingFrame* rolling);

}  // namespace contactd
