#include "contactd/half_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contactd/error.hpp"

namespace contactd {
namespace {

// Integrals over a rectangle of the functions the kernels are made of; that of 1/rho is xx + yy.
struct KernelIntegrals {
    double xx = 0;  // x^2/rho^3
    double yy = 0;  // y^2/rho^3
    double xy = 0;  // x y/rho^3
    double x = 0;   // x/rho^2
    double y = 0;   // y/rho^2
};

// y ln(x + rho) up to y ln|y|, which drops out of differences in x; asinh loses no digits for x < 0.
double y_log(double x, double y) {
    if (std::abs(y) <= 1e-200 * std::abs(x)) return 0;
    return y * std::asinh(x / std::abs(y));
}

double product_with_log(double y, double rho) {
    return rho > 0 ? y * std::log(rho) : 0;
}
double product_with_atan(double x, double y) {
    return x == 0 ? 0 : x * std::atan(y / x);
}

// Differences of the antiderivatives between the four corners.
KernelIntegrals by_antiderivatives(double x, double y, double dx, double dy) {
    KernelIntegrals sum;
    for (const int sx : {-1, 1})
        for (const int sy : {-1, 1}) {
            const double sign = sx * sy;
            const double X = x + 0.5 * sx * dx, Y = y + 0.5 * sy * dy;
            const double rho = std::hypot(X, Y);
            sum.xx += sign * y_log(X, Y);
            sum.yy += sign * y_log(Y, X);
            sum.xy -= sign * rho;
            sum.x += sign * (product_with_log(Y, rho) + product_with_atan(X, Y));
            sum.y += sign * (product_with_log(X, rho) + product_with_atan(Y, X));
        }
    return sum;
}

template <std::size_t n>
struct GaussRule {
    std::array<double, n> node, weight;  // on [-1/2, 1/2]
};

constexpr GaussRule<3> gauss3 = {{-0.387298334620741689, 0, 0.387298334620741689},
                                 {0.277777777777777778, 0.444444444444444444, 0.277777777777777778}};
constexpr GaussRule<6> gauss6 = {{-0.466234757101576014, -0.330604693233132257, -0.119309593041598454,
                                  0.119309593041598454, 0.330604693233132257, 0.466234757101576014},
                                 {0.085662246189585173, 0.180380786524069304, 0.233956967286345524,
                                  0.233956967286345524, 0.180380786524069304, 0.085662246189585173}};

template <std::size_t n>
KernelIntegrals by_quadrature(const GaussRule<n>& rule, double x, double y, double dx, double dy) {
    KernelIntegrals sum;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double weight = rule.weight[i] * rule.weight[j] * dx * dy;
            const double X = x + rule.node[i] * dx, Y = y + rule.node[j] * dy;
            const double per_rho2 = 1 / (X * X + Y * Y);
            const double per_rho3 = per_rho2 * std::sqrt(per_rho2);
            sum.xx += weight * X * X * per_rho3;
            sum.yy += weight * Y * Y * per_rho3;
            sum.xy += weight * X * Y * per_rho3;
            sum.x += weight * X * per_rho2;
            sum.y += weight * Y * per_rho2;
        }
    return sum;
}

// The differences of antiderivatives lose digits as (rho/size)^2. Far away, where the kernels are smooth over the
// rectangle, Gauss's rule does not; its error falls as (4 rho/size)^(-2n), below rounding for the limits chosen.
KernelIntegrals kernel_integrals(double x, double y, double dx, double dy) {
    const double scale = std::sqrt(dx * dy);  // the integrals are homogeneous of degree one
    const double ax = std::abs(x) / scale, ay = std::abs(y) / scale;
    const double wx = dx / scale, wy = dy / scale;
    const double distance = std::hypot(ax, ay) / std::max(wx, wy);
    KernelIntegrals result = distance > 100 ? by_quadrature(gauss3, ax, ay, wx, wy)
                             : distance > 8 ? by_quadrature(gauss6, ax, ay, wx, wy)
                                            : by_antiderivatives(ax, ay, wx, wy);
    const double sign_x = x < 0 ? -scale : x > 0 ? scale : 0;  // exact zeros on the axes
    const double sign_y = y < 0 ? -1 : y > 0 ? 1 : 0;
    result.xx *= scale;
    result.yy *= scale;
    result.xy *= sign_x * sign_y;
    result.x *= sign_x;
    result.y *= sign_y * scale;
    return result;
}

// Displacement along i for a load along j, times G.
double scaled_coefficient(Axis i, Axis j, const KernelIntegrals& k, double nu) {
    using std::numbers::pi;
    if (i == Axis::z && j == Axis::z) return (1 - nu) * (k.xx + k.yy) / (2 * pi);
    if (i == Axis::x && j == Axis::x) return (k.xx + (1 - nu) * k.yy) / (2 * pi);
    if (i == Axis::y && j == Axis::y) return (k.yy + (1 - nu) * k.xx) / (2 * pi);
    if (i != Axis::z && j != Axis::z) return nu * k.xy / (2 * pi);
    const Axis tangential = i == Axis::z ? j : i;
    const double sign = i == Axis::z ? -1 : 1;  // reciprocity: A_zx(x, y) = A_xz(-x, -y)
    return sign * (1 - 2 * nu) * (tangential == Axis::x ? k.x : k.y) / (4 * pi);
}

IcTable closed_form(const IcSpec& spec) {
    IcTable table(spec.nx, spec.ny);
    for (int l = 0; l < spec.ny; ++l)
        for (int k = 0; k < spec.nx; ++k) {
            const KernelIntegrals integrals = kernel_integrals(k * spec.dx, l * spec.dy, spec.dx, spec.dy);
            for (const Axis i : {Axis::x, Axis::y, Axis::z})
                for (const Axis j : {Axis::x, Axis::y, Axis::z})
                    table(i, j, k, l) = scaled_coefficient(i, j, integrals, spec.material.nu) / spec.material.G;
        }
    return table;
}

ComponentError relative_error(const IcTable& table, const IcTable& exact, Axis i) {
    ComponentError error;
    error.origin = table(i, i, 0, 0) / exact(i, i, 0, 0) - 1;
    for (int l = 0; l < exact.ny; ++l)
        for (int k = 0; k < exact.nx; ++k)
            error.largest = std::max(error.largest, std::abs(table(i, i, k, l) / exact(i, i, k, l) - 1));
    return error;
}

double scaled_error(const IcSpec& spec, const IcTable& table, const IcTable& exact, Axis i, Axis j) {
    double largest = 0;
    for (int l = 0; l < exact.ny; ++l)
        for (int k = 0; k < exact.nx; ++k) {
            if (k == 0 && l == 0) continue;
            const double rho = std::hypot(k * spec.dx, l * spec.dy);
            largest = std::max(largest, std::abs(table(i, j, k, l) - exact(i, j, k, l)) * rho);
        }
    return largest * 2 * std::numbers::pi * spec.material.G / (spec.dx * spec.dy);
}

}  // namespace

double half_space_coefficient(Axis i, Axis j, double x, double y, double dx, double dy, const Material& material) {
    return scaled_coefficient(i, j, kernel_integrals(x, y, dx, dy), material.nu) / material.G;
}

IcTable half_space_table(const IcSpec& spec) {
    if (spec.source != IcSource::analytic)
        throw InvalidArgument("ics.source", "is \"fem\"; closed-form coefficients need \"analytic\"");
    validate(spec);
    return closed_form(spec);
}

void compare_with_half_space(const IcSpec& spec, const IcTable& table, IcEvidence& evidence) {
    if (table.nx != spec.nx || table.ny != spec.ny)
        throw InvalidArgument("table", "has another extent than its spec; both must be the same");
    const IcTable exact = closed_form(spec);
    evidence.error_xx = relative_error(table, exact, Axis::x);
    evidence.error_yy = relative_error(table, exact, Axis::y);
    evidence.error_zz = relative_error(table, exact, Axis::z);
    const auto largest = [&](std::initializer_list<std::array<Axis, 2>> components) {
        double error = 0;
        for (const auto& [i, j] : components) error = std::max(error, scaled_error(spec, table, exact, i, j));
        return error;
    };
    using enum Axis;
    evidence.scaled_error_xy = largest({{x, y}, {y, x}});
    evidence.scaled_error_xz = largest({{x, z}, {z, x}, {y, z}, {z, y}});
}

}  // namespace contactd
