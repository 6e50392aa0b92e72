// Checks the closed forms of Cattaneo and Mindlin and of Vermeulen and Johnson against the half-space's coefficients.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <variant>

#include "closed_forms/simplified/cattaneo_mindlin.hpp"
#include "closed_forms/simplified/vermeulen_johnson.hpp"
#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "support/closed_forms.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;
const Material soft{200, 0.42}, hard{500, 0.1};
const EllipticContact ellipse{{1.5, 1}, 10, combined_material({soft, hard})};
constexpr double mu = 0.4, bound = mu * 10;

Grid window(int n) {
    return Grid::of_elements(n, n, 3.2 / n, 2.2 / n);
}

// Returns the displacement difference (x, y) of the two bodies at a point, from the tractions on the grid.
std::array<double, 2> displacement(const Grid& grid, const EllipticFriction& friction, double x, double y) {
    std::array<double, 2> u{};
    for (std::size_t i = 0; i < grid.size(); ++i) {
        if (friction.element_division[i] == ElementState::exterior) continue;
        const double dx = x - grid.x(static_cast<int>(i) % grid.nx), dy = y - grid.y(static_cast<int>(i) / grid.nx);
        const std::array<double, 2> p{friction.traction_x[i], friction.traction_y[i]};
        for (int k = 0; k < 2; ++k)
            for (int l = 0; l < 2; ++l)
                for (const Material& body : {soft, hard})
                    u[k] += p[l] * half_space_coefficient(static_cast<Axis>(k), static_cast<Axis>(l), dx, dy, grid.dx,
                                                          grid.dy, body);
    }
    return u;
}

double sum_of(const Grid& grid, const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) * grid.element_area();
}

}  // namespace

TEST_CASE("one material stands for both, a rigid one doubles the stiffness", "[elliptic]") {
    const Material same = combined_material({soft, soft}), stiff = combined_material({soft, Material::rigid()});
    CHECK_THAT(same.G, WithinRel(200.0, 1e-12));
    CHECK_THAT(same.nu, WithinRel(0.42, 1e-12));
    CHECK_THAT(stiff.G, WithinRel(400.0, 1e-12));
    CHECK_THAT(stiff.nu, WithinRel(0.42, 1e-12));
}

TEST_CASE("Hertz's pressure adds up to the force", "[elliptic]") {
    const Grid grid = window(100);
    const auto pressure = hertz_pressure(grid, ellipse);
    CHECK_THAT(sum_of(grid, pressure), WithinRel(10.0, 0.002));
    CHECK_THAT(ellipse.pmax(), WithinRel(15 / (pi * 1.5), 1e-12));
    CHECK(hertz_pressure(grid, {{0, 0}, 0, soft})[5050] == 0);
}

TEST_CASE("a circle is shifted as Cattaneo says", "[elliptic]") {
    const MaterialPair bodies{soft, hard};
    const EllipticContact circle{{1, 1}, 10, combined_material(bodies)};
    Shift shift;
    shift.force.Fx = 0.875 * bound;
    const auto result = cattaneo_mindlin(window(5), circle, mu, shift);
    const auto expected = reference::cattaneo(bodies, {1, 10, 0}, mu, *shift.force.Fx);
    CHECK_THAT(std::get<Shift>(result.motion).rigid_shift.x, WithinRel(-expected.rigid_shift, 1e-12));
    CHECK_THAT(result.Fx, WithinRel(*shift.force.Fx, 1e-12));
    CHECK_THAT(result.adhesion_area, WithinRel(pi * 0.25, 1e-9));
}

TEST_CASE("the adhesion area of a shifted ellipse follows the shift", "[elliptic]") {
    const Grid grid = window(60);
    Shift shift;
    shift.rigid_shift.x = 0.003;
    shift.rigid_shift.y = -0.0015;
    const auto result = cattaneo_mindlin(grid, ellipse, mu, shift);
    REQUIRE(result.adhesion_area > 0.1 * ellipse.area());
    for (const auto& [x, y] : {std::array{0.0, 0.0}, std::array{0.3, 0.0}, std::array{-0.1, 0.2}}) {
        const auto u = displacement(grid, result, x, y);
        CHECK_THAT(u[0], WithinAbs(-0.003, 3e-5));
        CHECK_THAT(u[1], WithinAbs(0.0015, 3e-5));
    }
    CHECK_THAT(sum_of(grid, result.traction_x), WithinRel(result.Fx, 0.01));
    CHECK_THAT(sum_of(grid, result.traction_y), WithinRel(result.Fy, 0.01));
}

TEST_CASE("the force of a shift gives the shift back", "[elliptic]") {
    Shift shift, asked;
    shift.rigid_shift.x = 0.003;
    shift.rigid_shift.y = -0.0015;
    const auto known = cattaneo_mindlin(window(5), ellipse, mu, shift);
    asked.force.Fx = known.Fx;
    SECTION("both forces") {
        asked.force.Fy = known.Fy;
    }
    SECTION("one force, one shift") {
        asked.rigid_shift.y = -0.0015;
    }
    const auto found = cattaneo_mindlin(window(5), ellipse, mu, asked);
    CHECK(found.force->converged);
    CHECK_THAT(std::get<Shift>(found.motion).rigid_shift.x, WithinRel(0.003, 1e-6));
    CHECK_THAT(std::get<Shift>(found.motion).rigid_shift.y, WithinRel(-0.0015, 1e-6));
}

TEST_CASE("a large shift slips everywhere, against the shift", "[elliptic]") {
    Shift shift;
    shift.rigid_shift.x = 3;
    shift.rigid_shift.y = 4;
    const auto result = cattaneo_mindlin(window(5), ellipse, mu, shift);
    CHECK_THAT(std::hypot(result.Fx, result.Fy), WithinRel(bound, 1e-12));
    CHECK_THAT(result.Fx, WithinRel(-0.6 * bound, 0.01));
    CHECK(result.adhesion_area == 0);
    CHECK(result.element_division[12] == ElementState::slip);
}

TEST_CASE("nothing jumps where the last adhesion ends", "[elliptic]") {
    Shift onset;
    onset.force.Fx = 0.6 * bound * (1 - 1e-12);
    onset.force.Fy = 0.8 * bound * (1 - 1e-12);
    const auto before = cattaneo_mindlin(window(5), ellipse, mu, onset);
    Shift shift = std::get<Shift>(before.motion);
    shift.rigid_shift.x *= 1.001;
    shift.rigid_shift.y *= 1.001;
    shift.force = {};
    const auto after = cattaneo_mindlin(window(5), ellipse, mu, shift);
    CHECK_THAT(after.Fx, WithinRel(0.6 * bound, 0.001));
    CHECK_THAT(after.Fy, WithinRel(0.8 * bound, 0.001));
}

TEST_CASE("closed forms refuse what they do not know", "[elliptic]") {
    Shift rotated, strong;
    rotated.rotation = 0.01;
    strong.force.Fy = -1.01 * bound;
    CHECK_THROWS_AS(cattaneo_mindlin(window(5), ellipse, mu, rotated), InvalidArgument);
    CHECK_THROWS_AS(cattaneo_mindlin(window(5), ellipse, mu, strong), InvalidArgument);
    Rolling spinning, oblique;
    spinning.phi = 0.01;
    oblique.chi = 0.5;
    CHECK_THROWS_AS(vermeulen_johnson(window(5), ellipse, mu, spinning), InvalidArgument);
    CHECK_THROWS_AS(vermeulen_johnson(window(5), ellipse, mu, oblique), InvalidArgument);
}

TEST_CASE("closed forms take frictionless and empty contacts", "[elliptic]") {
    Shift shift;
    shift.rigid_shift.x = 1;
    const auto smooth = cattaneo_mindlin(window(5), ellipse, 0, shift);
    CHECK(smooth.Fx == 0);
    CHECK(smooth.element_division[12] == ElementState::slip);
    const auto nothing = vermeulen_johnson(window(5), {{0, 0}, 0, soft}, mu, {});
    CHECK(nothing.Fx == 0);
    CHECK(nothing.element_division[12] == ElementState::exterior);
}

TEST_CASE("Vermeulen's and Johnson's adhesion area stretches by the creepage", "[elliptic]") {
    const double chi = GENERATE(0.0, pi);
    const Grid grid = window(60);
    Rolling rolling;
    rolling.xi = 0.0015;
    rolling.eta = 0.0008;
    rolling.chi = chi;
    const auto result = vermeulen_johnson(grid, ellipse, mu, rolling);
    REQUIRE(result.adhesion_area > 0.1 * ellipse.area());
    // In the steady state, the slip is w minus the derivative of u along the rolling direction.
    const double direction = std::cos(chi), x = 0.7 * direction, h = 0.2;
    const auto ahead = displacement(grid, result, x + h * direction, 0.05);
    const auto behind = displacement(grid, result, x - h * direction, 0.05);
    CHECK_THAT((ahead[0] - behind[0]) / (2 * h), WithinRel(0.0015, 0.03));
    CHECK_THAT((ahead[1] - behind[1]) / (2 * h), WithinRel(0.0008, 0.03));
    CHECK((result.Fx < 0 && result.Fy < 0));
    CHECK_THAT(sum_of(grid, result.traction_x), WithinRel(result.Fx, 0.01));
    double Mz = 0;
    for (std::size_t i = 0; i < grid.size(); ++i)
        Mz += grid.x(static_cast<int>(i) % 60) * result.traction_y[i] * grid.element_area() -
              grid.y(static_cast<int>(i) / 60) * result.traction_x[i] * grid.element_area();
    CHECK_THAT(Mz, WithinRel(result.Mz, 0.01));
}

TEST_CASE("Vermeulen's and Johnson's circle has Johnson's slopes", "[elliptic]") {
    const EllipticContact circle{{2, 2}, 10, soft};
    Rolling rolling;
    rolling.xi = 1e-7;
    const auto along = vermeulen_johnson(window(3), circle, mu, rolling);
    CHECK_THAT(along.Fx, WithinRel(-200 * 4 * 16 / (4 - 3 * 0.42) * 1e-7, 1e-3));
    rolling.xi = 0;
    rolling.eta = 1e-7;
    const auto across = vermeulen_johnson(window(3), circle, mu, rolling);
    CHECK_THAT(across.Fy, WithinRel(-200 * 4 * 16 / (4 - 0.42) * 1e-7, 1e-3));
}

TEST_CASE("Vermeulen's and Johnson's full slip is against the creepage", "[elliptic]") {
    Rolling rolling;
    rolling.xi = -3;
    rolling.eta = 4;
    const auto result = vermeulen_johnson(window(5), ellipse, mu, rolling);
    CHECK_THAT(result.Fx, WithinRel(0.6 * bound, 0.001));
    CHECK_THAT(result.Fy, WithinRel(-0.8 * bound, 0.001));
    CHECK(result.adhesion_area == 0);
    CHECK_THAT(*result.frictional_power, WithinRel(5 * bound, 0.001));
}

TEST_CASE("Vermeulen's and Johnson's forces give the creepages back", "[elliptic]") {
    Rolling rolling, asked;
    rolling.xi = 0.002;
    rolling.eta = -0.001;
    const auto known = vermeulen_johnson(window(5), ellipse, mu, rolling);
    asked.force.Fy = known.Fy;
    SECTION("both forces") {
        asked.force.Fx = known.Fx;
    }
    SECTION("one force, one creepage") {
        asked.xi = 0.002;
    }
    const auto found = vermeulen_johnson(window(5), ellipse, mu, asked);
    CHECK(found.force->converged);
    CHECK_THAT(std::get<Rolling>(found.motion).xi, WithinRel(0.002, 1e-6));
    CHECK_THAT(std::get<Rolling>(found.motion).eta, WithinRel(-0.001, 1e-6));
    CHECK_THAT(found.Fx, WithinRel(known.Fx, 1e-6));
}
