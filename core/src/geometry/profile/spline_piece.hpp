// Represents one interval of a profile's curve: two cubics, their length, and roots of functions over them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace contactd::geometry {

/// Holds coefficients of powers of t.
struct Cubic {
    std::array<double, 4> c{};

    double value(double t) const { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }
    double first(double t) const { return c[1] + t * (2 * c[2] + t * 3 * c[3]); }
    double second(double t) const { return 2 * c[2] + 6 * t * c[3]; }
};

/// Holds y and z over one interval, in powers of s from its beginning.
struct SplinePiece {
    Cubic y{}, z{};

    double speed(double t) const { return std::hypot(y.first(t), z.first(t)); }

    /// Returns the length from the beginning to t, by Gauss's rule with five points.
    double length(double t) const {
        constexpr std::array<double, 3> nodes{0, 0.5384693101056831, 0.9061798459386640};
        constexpr std::array<double, 3> weights{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
        const double half = 0.5 * t;
        double sum = weights[0] * speed(half);
        for (std::size_t k = 1; k < nodes.size(); ++k)
            sum += weights[k] * (speed(half * (1 + nodes[k])) + speed(half * (1 - nodes[k])));
        return half * sum;
    }
};

/// Returns the t in [0, end] where an ascending function is zero, by Newton's method between shrinking bounds.
template <class Function>
double root(double end, double start, const Function& value_and_slope) {
    double low = 0, high = end, t = start;
    for (int iteration = 0; iteration < 60; ++iteration) {
        const auto [excess, slope] = value_and_slope(t);
        if (excess == 0) break;
        (excess > 0 ? high : low) = t;
        double next = t - excess / slope;
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
        const bool settled = std::abs(next - t) <= 1e-15 * (end + t);
        t = next;
        if (settled) break;
    }
    return t;
}

}  // namespace contactd::geometry
