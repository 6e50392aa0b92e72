#include "hertz.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using std::numbers::pi;

void require_positive(double value, const char* field) {
    if (!(value > 0) || !std::isfinite(value))
        throw InvalidArgument(field, "is " + number_text(value) + "; it must be positive and finite");
}

void require_finite(double value, const char* field) {
    if (!std::isfinite(value)) throw InvalidArgument(field, "is " + number_text(value) + "; it must be finite");
}

// Holds B = (E - (1 - e^2) K)/e^2 and D = (K - E)/e^2, K = B + D, where e^2 = 1 - (b/a)^2 and K, E are the complete
// elliptic integrals of modulus e.
struct Elliptic {
    double B, D;
    double K() const { return B + D; }

    // Returns the slope of log((b/a)^2 D/B) over log(b/a): 1.5 for a circle, up to 2 for a line. It follows from dB/de
    // = (D - B)/e and dD/de = (B/(1 - e^2) - D)/e, whose differences cancel near a circle.
    double slope(double ratio) const {
        constexpr double circle = 1.5, line = 2, nearly_circular = 1e-6;
        const double r2 = ratio * ratio, e2 = (1 - ratio) * (1 + ratio);
        if (e2 < nearly_circular) return circle;
        return std::clamp(2 + ((r2 * D - B) / D + r2 * (D - B) / B) / e2, circle, line);
    }
};

// Uses the arithmetic-geometric mean (Abramowitz and Stegun 17.6): E = K (1 - sum 2^(n-1) c_n^2). Differences are taken
// in closed form, so that nearly circular ellipses lose no digits. Therefore std::comp_ellint_1 and _2 are not
// suitable.
Elliptic elliptic(double ratio) {  // b/a <= 1
    if (ratio == 1) return {pi / 4, pi / 4};
    const double e2 = (1 - ratio) * (1 + ratio);
    double mean = 1, geometric = ratio, c2 = e2, power = 0.5, sum = 0.5;  // sum of 2^(n-1) c_n^2 / e^2
    while (c2 > 1e-34) {
        const double next = 0.5 * (mean + geometric), c = c2 / (4 * next);
        geometric = std::sqrt(mean * geometric);
        mean = next;
        c2 = c * c;
        power *= 2;
        sum += power * c2 / e2;
    }
    const double K = pi / (2 * mean);
    return {K * (1 - sum), K * sum};
}

// Uses Johnson (4.26)-(4.29), a >= b: with q = pmax/E*, 1/(2 Rx) = q (b/a) D/a, 1/(2 Ry) = q B/b, approach = q b K.
struct Shape {
    static constexpr double usual_share = 0.636;  // approximate ratio of log(b/a) to log(R_smaller/R_larger)
    static constexpr double rounding = 4e-16;

    double ratio;  // shorter over longer semi-axis
    bool along_y;  // whether the longer semi-axis is along y
    Elliptic integrals;

    explicit Shape(const SemiAxes& axes)
        : ratio(std::min(axes.a, axes.b) / std::max(axes.a, axes.b)),
          along_y(axes.b > axes.a),
          integrals(elliptic(ratio)) {}

    // Solves log((b/a)^2 D/B) = log(R_smaller/R_larger) for the ratio of the radii by Newton's method.
    explicit Shape(const Paraboloid& gap) : ratio(1), along_y(gap.Ry > gap.Rx) {
        const double target = std::log(std::min(gap.Rx, gap.Ry) / std::max(gap.Rx, gap.Ry));
        double log_ratio = usual_share * target;
        for (int iteration = 0; iteration < 60; ++iteration) {
            ratio = std::exp(log_ratio);
            integrals = elliptic(ratio);
            const double defect = 2 * log_ratio + std::log(integrals.D / integrals.B) - target;
            const double next = std::min(log_ratio - defect / integrals.slope(ratio), 0.0);
            if (std::abs(next - log_ratio) <= rounding * (1 + std::abs(log_ratio))) break;
            log_ratio = next;
        }
    }

    // Returns 1/(2 R) of the shorter direction, times b/q, which is the stronger curvature.
    double strong_curvature() const { return integrals.B; }
    double weak_curvature() const { return ratio * ratio * integrals.D; }
    SemiAxes axes(double shorter) const {
        return along_y ? SemiAxes{shorter, shorter / ratio} : SemiAxes{shorter / ratio, shorter};
    }
    Paraboloid radii(double shorter, double q) const {
        const double strong = shorter / (2 * q * strong_curvature()), weak = shorter / (2 * q * weak_curvature());
        return along_y ? Paraboloid{strong, weak} : Paraboloid{weak, strong};
    }
    // Returns the contact from the shorter semi-axis and q = pmax/E*.
    HertzContact contact(double shorter, double q, double compliance) const {
        const SemiAxes ellipse = axes(shorter);
        const double pmax = q / compliance;
        return {ellipse.a, ellipse.b, pmax, q * shorter * integrals.K(), 2 * pi / 3 * ellipse.a * ellipse.b * pmax};
    }
};

void check(const Paraboloid& gap, double compliance) {
    require_positive(gap.Rx, "gap.Rx");
    require_positive(gap.Ry, "gap.Ry");
    require_positive(compliance, "bodies");
}

void check(const SemiAxes& axes) {
    require_positive(axes.a, "gap.a");
    require_positive(axes.b, "gap.b");
}

// Return q of the ellipse, from the force or from the approach.
double q_of_force(const SemiAxes& axes, double compliance, double Fn) {
    return 1.5 * Fn * compliance / (pi * axes.a * axes.b);
}
double q_of_approach(const Shape& shape, double shorter, double approach) {
    return approach / (shorter * shape.integrals.K());
}

double shorter_of(const SemiAxes& axes) {
    return std::min(axes.a, axes.b);
}

}  // namespace

HertzContact hertz_of_force(const Paraboloid& gap, double compliance, double Fn) {
    check(gap, compliance);
    require_finite(Fn, "Fn");
    if (!(Fn > 0)) return {};
    const Shape shape(gap);
    // These follow from 1/(2R) = q B/b and q = 3 Fn c/(2 pi a b) with a = b/ratio.
    const double R = std::min(gap.Rx, gap.Ry);
    const double shorter = std::cbrt(3 * R * Fn * compliance * shape.ratio * shape.strong_curvature() / pi);
    HertzContact contact = shape.contact(shorter, shorter / (2 * R * shape.strong_curvature()), compliance);
    contact.Fn = Fn;
    return contact;
}

HertzContact hertz_of_approach(const Paraboloid& gap, double compliance, double approach) {
    check(gap, compliance);
    require_finite(approach, "approach");
    HertzContact contact;
    contact.approach = approach;
    if (!(approach > 0)) return contact;
    const Shape shape(gap);
    // These follow from 1/(2R) = q B/b and approach = q b K.
    const double R = std::min(gap.Rx, gap.Ry);
    const double shorter = std::sqrt(2 * R * approach * shape.strong_curvature() / shape.integrals.K());
    contact = shape.contact(shorter, shorter / (2 * R * shape.strong_curvature()), compliance);
    contact.approach = approach;
    return contact;
}

namespace {

void check(const CylinderGap& gap, double compliance) {
    require_positive(gap.R, "gap.paraboloid.Rx");
    require_positive(gap.length, "grid.dy");
    require_positive(gap.datum, "ics.line_contact.datum");
    require_positive(compliance, "bodies");
}

[[noreturn]] void refuse_datum(const CylinderGap& gap, const std::string& how) {
    throw InvalidArgument("ics.line_contact.datum", "is " + number_text(gap.datum) +
                                                        ", but the half-width of the contact " + how +
                                                        "; the datum must lie outside the contact");
}

double approach_of(const CylinderGap& gap, double a) {
    return a * a / (2 * gap.R) * (std::log(2 * gap.datum / a) + 0.5);
}

HertzContact line_contact(const CylinderGap& gap, double compliance, double a) {
    const double pmax = a / (2 * gap.R * compliance);
    return {a, std::numeric_limits<double>::infinity(), pmax, approach_of(gap, a), 0.5 * pi * a * gap.length * pmax};
}

}  // namespace

HertzContact hertz_of_line_force(const CylinderGap& gap, double compliance, double Fn) {
    check(gap, compliance);
    require_finite(Fn, "Fn");
    if (!(Fn > 0)) return {};
    const double a = std::sqrt(4 * Fn / gap.length * gap.R * compliance / pi);
    if (a > gap.datum) refuse_datum(gap, "is " + number_text(a) + " mm");
    HertzContact contact = line_contact(gap, compliance, a);
    contact.Fn = Fn;
    return contact;
}

// Solves by Newton's method on the logarithms of width and approach, of which one grows 1.1 to 2 times as fast as the
// other.
HertzContact hertz_of_line_approach(const CylinderGap& gap, double compliance, double approach) {
    check(gap, compliance);
    require_finite(approach, "approach");
    HertzContact contact;
    contact.approach = approach;
    if (!(approach > 0)) return contact;
    if (approach > approach_of(gap, gap.datum)) refuse_datum(gap, "is larger");
    double log_a = std::log(gap.datum);
    for (int iteration = 0; iteration < 60; ++iteration) {
        const double a = std::exp(log_a), slope = 2 - 1 / (std::log(2 * gap.datum / a) + 0.5);
        const double change = (std::log(approach_of(gap, a)) - std::log(approach)) / slope;
        log_a -= change;
        if (std::abs(change) <= Shape::rounding * (1 + std::abs(log_a))) break;
    }
    contact = line_contact(gap, compliance, std::exp(log_a));
    contact.approach = approach;
    return contact;
}

HertzContact hertz_of_semi_axes_and_force(const SemiAxes& axes, double compliance, double Fn) {
    check(axes);
    require_positive(compliance, "bodies");
    require_positive(Fn, "Fn");
    HertzContact contact = Shape(axes).contact(shorter_of(axes), q_of_force(axes, compliance, Fn), compliance);
    return {axes.a, axes.b, contact.pmax, contact.approach, Fn};
}

HertzContact hertz_of_semi_axes_and_approach(const SemiAxes& axes, double compliance, double approach) {
    check(axes);
    require_positive(compliance, "bodies");
    require_positive(approach, "approach");
    const Shape shape(axes);
    const double shorter = shorter_of(axes);
    const HertzContact contact = shape.contact(shorter, q_of_approach(shape, shorter, approach), compliance);
    return {axes.a, axes.b, contact.pmax, approach, contact.Fn};
}

Paraboloid radii_of_force(const SemiAxes& axes, double compliance, double Fn) {
    check(axes);
    require_positive(compliance, "bodies");
    require_positive(Fn, "Fn");
    return Shape(axes).radii(shorter_of(axes), q_of_force(axes, compliance, Fn));
}

Paraboloid radii_of_approach(const SemiAxes& axes, double approach) {
    check(axes);
    require_positive(approach, "approach");
    const Shape shape(axes);
    const double shorter = shorter_of(axes);
    return shape.radii(shorter, q_of_approach(shape, shorter, approach));
}

}  // namespace contactd
