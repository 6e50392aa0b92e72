#include "full_slip.hpp"

#include <cmath>
#include <numbers>

namespace contactd::creep_table {
namespace {

using std::numbers::pi;

// The integrands have period pi, so equally spaced points converge exponentially: as exp(-2 N b/a) for a > b.
constexpr int points_of_full_slip = 1024;

constexpr int rays = 4096;

/// Holds the integrals of sqrt(m - v^2) (v - t) and sqrt(m - v^2) (v - t) v along a chord of the unit circle, where v
/// is measured from the middle of the chord.
struct ChordIntegrals {
    double plain, times_v;
};

// From v = t, the pole of the slip, to the edge. The root at the pole is the same for all rays.
ChordIntegrals from_inside(double t, double m, double root) {
    const double angle = std::atan2(root, t);
    const double K0 = (m * angle - t * root) / 2, K1 = root * root * root / 3;
    const double K2 = m * m / 8 * angle - t * (2 * t * t - m) * root / 8;
    return {K1 - t * K0, K2 - t * K1};
}

// Over the whole chord, for a pole outside.
ChordIntegrals across(double t, double m) {
    return {-t * pi / 2 * m, pi / 8 * m * m};
}

/// Adds the contributions of rays from the pole of the slip, along which the slip has one direction. Ellipse and pole
/// are scaled to the unit circle.
struct RaySum {
    double a, b, pole_x, pole_y;
    Triple total{};

    double along(double cos, double sin) const { return pole_x * cos + pole_y * sin; }
    double aside(double cos, double sin) const { return pole_y * cos - pole_x * sin; }

    void add(double cos, double sin, const ChordIntegrals& chord, double weight) {
        const double length = std::hypot(a * cos, b * sin), q = aside(cos, sin);
        total[0] -= weight * b * sin / length * chord.plain;
        total[1] += weight * a * cos / length * chord.plain;
        total[2] += weight * ((b * b - a * a) * q * cos * sin / length * chord.plain + length * chord.times_v);
    }
};

void add_from_inside(RaySum& sum) {
    const double root = std::sqrt(1 - sum.pole_x * sum.pole_x - sum.pole_y * sum.pole_y);
    for (int i = 0; i < rays; ++i) {
        const double angle = 2 * pi * (i + 0.5) / rays, cos = std::cos(angle), sin = std::sin(angle);
        const double t = sum.along(cos, sin), q = sum.aside(cos, sin);
        sum.add(cos, sin, from_inside(t, 1 - q * q, root), 2 * pi / rays);
    }
}

// With q = sin s the distance of a ray from the centre, the integrand vanishes as cos^3 s at its ends.
void add_from_outside(RaySum& sum, double distance) {
    const double centre_x = -sum.pole_x / distance, centre_y = -sum.pole_y / distance;
    for (int i = 0; i < rays; ++i) {
        const double s = pi * ((i + 0.5) / rays - 0.5), sine = std::sin(s) / distance,
                     cosine = std::sqrt(1 - sine * sine);
        const double cos = centre_x * cosine - centre_y * sine, sin = centre_y * cosine + centre_x * sine;
        const double m = std::cos(s) * std::cos(s);
        sum.add(cos, sin, across(-distance * cosine, m), pi / rays * std::cos(s) / (distance * cosine));
    }
}

}  // namespace

Triple full_slip(double a_over_b, double nu) {
    const double a = std::sqrt(a_over_b), b = 1 / a;
    double xi = 0, eta = 0;
    for (int i = 0; i < points_of_full_slip; ++i) {
        const double t = pi * (i + 0.5) / points_of_full_slip, cos2 = std::cos(t) * std::cos(t), sin2 = 1 - cos2;
        const double r2 = a * a * cos2 + b * b * sin2, weight = sin2 / std::sqrt(r2);
        const double share = nu * a * a * cos2 / r2;
        xi += (1 - nu + share) * weight;
        eta += (1 - share) * weight;
    }
    const double unit = 3 * b / (2 * points_of_full_slip);
    xi *= unit;
    eta *= unit;
    return {xi, eta, 1 / std::hypot(b / xi, a / eta)};
}

Triple forces_at_infinite_creepage(double a_over_b, const Triple& direction) {
    constexpr double farthest_pole = 1e8;  // in semi-axes, beyond which spin has no effect
    const auto [xi, eta, phi] = direction;
    const double a = std::sqrt(a_over_b), b = 1 / a;
    const double slip = std::hypot(xi, eta), pole = std::hypot(eta / a, xi / b);
    if (pole >= farthest_pole * std::abs(phi)) return {xi / slip, eta / slip, 0};
    RaySum sum{a, b, -eta / phi / a, xi / phi / b};
    const double distance = pole / std::abs(phi);
    if (distance < 1)
        add_from_inside(sum);
    else
        add_from_outside(sum, distance);
    const double unit = std::copysign(3 / (2 * pi), phi);
    return {unit * sum.total[0], unit * sum.total[1], unit * sum.total[2]};
}

}  // namespace contactd::creep_table
