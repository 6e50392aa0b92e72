// Tests displacements inside the half-space.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "influence/half_space_cases.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

using Vector = std::array<double, 3>;
using Field = std::function<Vector(const Vector&)>;

double norm(const Vector& v) {
    return std::hypot(v[0], v[1], v[2]);
}

double distance(const Vector& a, const Vector& b) {
    return norm({a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

Vector moved(Vector point, std::size_t axis, double by) {
    point[axis] += by;
    return point;
}

// Returns d/d(axis) by central differences, or downwards from the surface, of second order.
Vector derivative(const Field& u, const Vector& point, std::size_t axis, double step) {
    Vector result{};
    const bool at_surface = axis == 2 && point[2] == 0;
    const Vector here = u(at_surface ? point : moved(point, axis, step)), back = u(moved(point, axis, -step));
    const Vector twice = at_surface ? u(moved(point, axis, -2 * step)) : Vector{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = (at_surface ? 3 * here[i] - 4 * back[i] + twice[i] : here[i] - back[i]) / (2 * step);
    return result;
}

// Row a, column b: stress over G.
std::array<Vector, 3> stress(const Field& u, const Vector& point, double nu, double step) {
    std::array<Vector, 3> gradient{};  // [axis][component]
    for (std::size_t a = 0; a < 3; ++a) gradient[a] = derivative(u, point, a, step);
    const double pressure = 2 * nu / (1 - 2 * nu) * (gradient[0][0] + gradient[1][1] + gradient[2][2]);
    std::array<Vector, 3> sigma{};
    for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b) sigma[a][b] = gradient[a][b] + gradient[b][a] + (a == b ? pressure : 0);
    return sigma;
}

// Composes the load of `spec` from loads that are `parts` times smaller.
Vector from_parts(const IcSpec& spec, Axis load, const Vector& point, int parts) {
    const bool is_bilinear = spec.load_shape == LoadShape::bilinear;
    IcSpec part = spec;
    part.dx /= parts;
    part.dy /= parts;
    Vector sum{};
    const int count = is_bilinear ? 2 * parts - 1 : parts;
    const auto weight = [&](int k) {
        return is_bilinear ? 1 - std::abs(k - (parts - 1)) / static_cast<double>(parts) : 1;
    };
    for (int k = 0; k < count; ++k)
        for (int l = 0; l < count; ++l) {
            const double x = (k - 0.5 * (count - 1)) * part.dx, y = (l - 0.5 * (count - 1)) * part.dy;
            const Vector u = half_space_displacement(part, load, {point[0] - x, point[1] - y, point[2]});
            for (std::size_t i = 0; i < 3; ++i) sum[i] += weight(k) * weight(l) * u[i];
        }
    return sum;
}

}  // namespace

TEST_CASE("the field at the surface is the influence coefficient", "[half_space]") {
    const auto load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const double aspect = GENERATE(0.25, 1.0, 4.0);
    const double nu = GENERATE(0.0, 0.28, 0.5);
    const IcSpec spec = analytic({200, nu}, 0.3, 0.3 / aspect, 1, 1, load_shape);
    const double size = std::max(spec.dx, spec.dy);
    const auto coefficient =
        load_shape == LoadShape::bilinear ? half_space_bilinear_coefficient : half_space_coefficient;
    for (const auto& [x, y] : {std::pair{3.0, 0.0}, {0.0, -3.0}, {-2.2, 2.1}, {5.0, -8.0}, {-90.0, 70.0}, {4.0, 300.0}})
        for (const Axis load : axes) {
            CAPTURE(aspect, nu, x, y, int(load));
            const Vector u = half_space_displacement(spec, load, {x * size, y * size, 0});
            Vector expected{};
            for (const Axis i : axes)
                expected[static_cast<std::size_t>(i)] =
                    coefficient(i, load, x * size, y * size, spec.dx, spec.dy, spec.material);
            CHECK(distance(u, expected) < 1e-8 * norm(expected));
        }
}

TEST_CASE("Gauss points suffice from three times the size of the load on", "[half_space]") {
    const auto load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const double aspect = GENERATE(0.1, 1.0, 10.0);
    const IcSpec spec = analytic({1, 0.3}, 1, 1 / aspect, 1, 1, load_shape);
    const double size = std::max(spec.dx, spec.dy);
    for (const Vector direction : {Vector{1, 0, 0}, {0, -0.6, -0.8}, {0, 0, -1}, {-0.48, 0.64, -0.6}})
        for (const double far : {3.0, 30.0, 101.0})
            for (const Axis load : axes) {
                CAPTURE(aspect, far, direction[0], direction[2], int(load));
                const Vector point = {far * size * direction[0], far * size * direction[1], far * size * direction[2]};
                const Vector fine = from_parts(spec, load, point, 4);
                CHECK(distance(half_space_displacement(spec, load, point), fine) < 1e-8 * norm(fine));
            }
}

TEST_CASE("the field is in equilibrium", "[half_space]") {
    const double nu = GENERATE(0.0, 0.28, 0.49);
    const IcSpec spec = analytic({1, nu}, 1, 0.7, 1, 1, LoadShape::bilinear);
    for (const Axis load : axes)
        for (const Vector point : {Vector{3, 2, -4}, {-5, 1, -2}, {0, 0, -6}, {2, -7, -0.5}}) {
            CAPTURE(nu, int(load), point[0], point[1], point[2]);
            const Field u = [&](const Vector& at) { return half_space_displacement(spec, load, at); };
            constexpr double step = 0.01;
            Vector divergence{};
            double largest = 0;
            for (std::size_t a = 0; a < 3; ++a) {
                const auto ahead = stress(u, moved(point, a, step), nu, step),
                           behind = stress(u, moved(point, a, -step), nu, step);
                for (std::size_t b = 0; b < 3; ++b) {
                    const double term = (ahead[a][b] - behind[a][b]) / (2 * step);
                    divergence[b] += term;
                    largest = std::max(largest, std::abs(term));
                }
            }
            CHECK(norm(divergence) < 1e-3 * largest / (1 - 2 * nu));
        }
}

TEST_CASE("the surface beside the load is free of traction", "[half_space]") {
    const double nu = GENERATE(0.0, 0.28, 0.49);
    const IcSpec spec = analytic({1, nu}, 1, 0.7, 1, 1);
    for (const Axis load : axes)
        for (const Vector point : {Vector{4, 0, 0}, {-3, 5, 0}, {0, -6, 0}}) {
            CAPTURE(nu, int(load), point[0], point[1]);
            const Field u = [&](const Vector& at) { return half_space_displacement(spec, load, at); };
            const auto sigma = stress(u, point, nu, 1e-3);
            const double largest = norm({norm(sigma[0]), norm(sigma[1]), norm(sigma[2])});
            CHECK(norm(sigma[2]) < 1e-4 * largest);
        }
}

// Over a hemisphere around the load, the tractions on the outward normal balance the load.
TEST_CASE("the stresses inside carry a load of dx dy", "[half_space]") {
    const auto load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const double nu = 0.3, radius = 6;
    const IcSpec spec = analytic({1, nu}, 1, 0.7, 1, 1, load_shape);
    constexpr int rings = 40, sectors = 24;
    for (const Axis load : axes) {
        const Field u = [&](const Vector& at) { return half_space_displacement(spec, load, at); };
        Vector force{};
        for (int ring = 0; ring < rings; ++ring)
            for (int sector = 0; sector < sectors; ++sector) {
                const double depth = (ring + 0.5) / rings, angle = 2 * std::numbers::pi * sector / sectors;
                const double lateral = std::sqrt(1 - depth * depth);
                const Vector normal = {lateral * std::cos(angle), lateral * std::sin(angle), -depth};
                const auto sigma = stress(u, {radius * normal[0], radius * normal[1], -radius * depth}, nu, 1e-3);
                for (std::size_t a = 0; a < 3; ++a)
                    for (std::size_t b = 0; b < 3; ++b) force[b] += sigma[a][b] * normal[a];
            }
        for (double& component : force) component *= 2 * std::numbers::pi * radius * radius / (rings * sectors);
        Vector expected{};
        expected[static_cast<std::size_t>(load)] = -spec.dx * spec.dy;
        CAPTURE(int(load), force[0], force[1], force[2]);
        CHECK(distance(force, expected) < 2e-3 * spec.dx * spec.dy);
    }
}

TEST_CASE("points above the surface are refused", "[half_space]") {
    const IcSpec spec = analytic({1, 0.3}, 1, 1, 1, 1);
    CHECK_THROWS_AS(half_space_displacement(spec, Axis::z, {5, 5, 0.1}), InvalidArgument);
    CHECK_NOTHROW(half_space_displacement(spec, Axis::z, {5, 5, 1e-15}));  // rounding of a mesh
}
