#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>
#include <variant>

#include "closed_forms/simplified/fastsim.hpp"
#include "contactd/error.hpp"
#include "support/closed_forms.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;
const Material steel{82000, 0.28};
const MaterialPair steel_pair{steel, steel};
const EllipticContact contact{{6, 4}, 50000, steel};
const EllipticContact circle{{5, 5}, 50000, steel};
constexpr double mu = 0.3, bound = mu * 50000;

Grid window(const EllipticContact& of, int n) {
    return Grid::of_elements(n, n, 2.2 * of.axes.a / n, 2.2 * of.axes.b / n);
}

Rolling rolling(double xi, double eta, double phi, double chi = 0) {
    Rolling motion;
    motion.xi = xi;
    motion.eta = eta;
    motion.phi = phi;
    motion.chi = chi;
    return motion;
}

}  // namespace

TEST_CASE("FASTSIM comes near the exact theory with spin", "[fastsim]") {
    // Lists the steady state of the exact theory, extrapolated from grids of 200 x 200 and 400 x 400 elements.
    const auto result = fastsim(window(contact, 25), contact, mu, rolling(0.002, 0.001, 1e-4));
    CHECK_THAT(result.Fx, WithinRel(-11427, 0.045));
    CHECK_THAT(result.Fy, WithinRel(-6817, 0.015));
    CHECK_THAT(result.Mz, WithinAbs(135, 0.01 * bound * std::sqrt(6 * 4)));
}

TEST_CASE("FASTSIM has exactly the forces of linear theory for vanishing creepage", "[fastsim]") {
    const double a = GENERATE(0.8, 4.0, 20.0);
    const auto settings = GENERATE(FastsimSettings{}, FastsimSettings{8, 8}, FastsimSettings{100, 31});
    const EllipticContact ellipse{{a, 4}, 50000, steel};
    const double c = std::sqrt(4 * a), unit = 1e-9 * bound / (steel.G * c * c);
    const auto [xi, eta, phi] =
        GENERATE_REF(std::array{unit, 0.0, 0.0}, std::array{0.0, unit, 0.0}, std::array{0.0, 0.0, unit / c});
    const auto result = fastsim(window(ellipse, 5), ellipse, mu, rolling(xi, eta, phi), settings);
    const auto linear = reference::linear_rolling(steel_pair, ellipse.axes, xi, eta, phi);
    CHECK_THAT(result.Fx, WithinRel(linear.Fx, 1e-7) || WithinAbs(0, 1e-12));
    CHECK_THAT(result.Fy, WithinRel(linear.Fy, 1e-7) || WithinAbs(0, 1e-12));
}

TEST_CASE("FASTSIM refuses ellipses that Kalker's coefficients do not reach", "[fastsim]") {
    const double chi = GENERATE(0.0, pi / 2), b = GENERATE(0.1, 150.0);
    const EllipticContact slender{{4, b}, 50000, steel};
    try {
        fastsim(window(slender, 5), slender, mu, rolling(0.001, 0, 0, chi));
        FAIL("was not refused");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "gap");
        CHECK_THAT(error.what(), ContainsSubstring(b < 1 ? "0.1 mm" : "150 mm") && ContainsSubstring("1/32 to 32") &&
                                     ContainsSubstring("model full"));
    }
}

TEST_CASE("FASTSIM in full slip has the force mu Fn against the creepage", "[fastsim]") {
    const double angle = GENERATE(0.0, 1.0, 4.0), chi = GENERATE(0.0, pi / 2);
    const auto result =
        fastsim(window(contact, 9), contact, mu, rolling(10 * std::cos(angle), 10 * std::sin(angle), 0, chi));
    CHECK_THAT(std::hypot(result.Fx, result.Fy), WithinRel(bound, 1e-6));
    CHECK_THAT(result.Fx, WithinAbs(-bound * std::cos(angle), 0.001 * bound));
    CHECK_THAT(result.Fy, WithinAbs(-bound * std::sin(angle), 0.001 * bound));
    CHECK_THAT(*result.frictional_power, WithinRel(10 * bound, 0.001));
    CHECK_THAT(result.slip_area, WithinRel(contact.area(), 1e-6));
}

TEST_CASE("FASTSIM's spin alone pushes sideways and turns against itself", "[fastsim]") {
    const double chi = GENERATE(0.0, pi);
    const auto result = fastsim(window(contact, 25), contact, mu, rolling(0, 0, 3e-4, chi));
    CHECK_THAT(result.Fx, WithinAbs(0, 1e-9 * bound));
    CHECK(result.Fy * std::cos(chi) < -0.1 * bound);
    CHECK(result.Mz < 0);
}

TEST_CASE("FASTSIM's samples obey the friction law and add up to the forces", "[fastsim]") {
    const Grid grid = window(contact, 80);
    const auto result = fastsim(grid, contact, mu, rolling(0.001, -0.0005, 2e-4), {64, 64});
    double Fx = 0, Fy = 0, power = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const double x = grid.x(static_cast<int>(i % 80)) / 6, y = grid.y(static_cast<int>(i / 80)) / 4;
        const double g = 2 * bound / contact.area() * std::max(0.0, 1 - x * x - y * y);
        const double p = std::hypot(result.traction_x[i], result.traction_y[i]);
        const double slip = std::hypot(result.slip_x[i], result.slip_y[i]);
        REQUIRE(p <= g * (1 + 1e-12));
        if (result.element_division[i] == ElementState::slip) REQUIRE_THAT(p, WithinRel(g, 1e-12));
        if (result.element_division[i] != ElementState::slip) REQUIRE(slip == 0);
        const double opposite = result.traction_x[i] * result.slip_x[i] + result.traction_y[i] * result.slip_y[i];
        REQUIRE_THAT(opposite, WithinAbs(-p * slip, 1e-3 * p * slip));
        Fx += p > 0 ? result.traction_x[i] * grid.element_area() : 0;
        Fy += p > 0 ? result.traction_y[i] * grid.element_area() : 0;
        power -= opposite * grid.element_area();
    }
    CHECK_THAT(Fx, WithinRel(result.Fx, 0.01));
    CHECK_THAT(Fy, WithinRel(result.Fy, 0.01));
    CHECK_THAT(power, WithinRel(*result.frictional_power, 0.08));  // steps lag behind the slip
    CHECK_THAT(result.adhesion_area + result.slip_area, WithinRel(contact.area(), 1e-9));
}

TEST_CASE("FASTSIM settles with finer steps", "[fastsim]") {
    const Rolling motion = rolling(0.002, 0.001, 1e-4);
    const auto fine = fastsim(window(contact, 1), contact, mu, motion, {1000, 1000});
    const auto coarse = fastsim(window(contact, 1), contact, mu, motion);
    CHECK_THAT(coarse.Fx, WithinRel(fine.Fx, 0.001));
    CHECK_THAT(coarse.Fy, WithinRel(fine.Fy, 0.006));
}

TEST_CASE("FASTSIM does not mind how the axes are named", "[fastsim]") {
    const EllipticContact rotated{{4, 6}, 50000, steel};
    const auto along_x = fastsim(window(contact, 12), contact, mu, rolling(0.001, 0.0005, 1e-4));
    const auto along_y = fastsim(window(rotated, 12), rotated, mu, rolling(-0.0005, 0.001, 1e-4, pi / 2));
    CHECK_THAT(along_y.Fy, WithinRel(along_x.Fx, 1e-12));
    CHECK_THAT(along_y.Fx, WithinRel(-along_x.Fy, 1e-12));
    CHECK_THAT(along_y.Mz, WithinRel(along_x.Mz, 1e-12));
    const std::size_t at = 4 * 12 + 7, there = 7 * 12 + (11 - 4);
    CHECK_THAT(along_y.traction_y[there], WithinRel(along_x.traction_x[at], 1e-9));
}

TEST_CASE("FASTSIM rolls a circle in any direction, an ellipse only along its axes", "[fastsim]") {
    const double chi = 0.6, c = std::cos(chi), s = std::sin(chi);
    const auto straight = fastsim(window(circle, 15), circle, mu, rolling(0.001, 0.0005, 1e-4));
    const auto oblique =
        fastsim(window(circle, 15), circle, mu, rolling(c * 0.001 - s * 0.0005, s * 0.001 + c * 0.0005, 1e-4, chi));
    CHECK_THAT(c * oblique.Fx + s * oblique.Fy, WithinRel(straight.Fx, 1e-9));
    CHECK_THAT(c * oblique.Fy - s * oblique.Fx, WithinRel(straight.Fy, 1e-9));
    const std::size_t middle = 7 * 15 + 7;
    CHECK_THAT(std::hypot(oblique.traction_x[middle], oblique.traction_y[middle]),
               WithinRel(std::hypot(straight.traction_x[middle], straight.traction_y[middle]), 0.02));
    CHECK_THROWS_AS(fastsim(window(contact, 5), contact, mu, rolling(0.001, 0, 0, chi)), InvalidArgument);
}

TEST_CASE("FASTSIM finds the creepages of prescribed forces", "[fastsim]") {
    const double chi = GENERATE(0.0, pi), phi = GENERATE(0.0, -2e-4);
    const auto known = fastsim(window(contact, 5), contact, mu, rolling(0.0012, -0.0007, phi, chi));
    Rolling asked = rolling(0, 0, phi, chi);
    asked.force.Fx = known.Fx;
    SECTION("both") {
        asked.force.Fy = known.Fy;
    }
    SECTION("one of them") {
        asked.eta = -0.0007;
    }
    const auto found = fastsim(window(contact, 5), contact, mu, asked);
    REQUIRE(found.force);
    CHECK(found.force->converged);
    CHECK_THAT(std::get<Rolling>(found.motion).xi, WithinRel(0.0012, 1e-6));
    CHECK_THAT(std::get<Rolling>(found.motion).eta, WithinRel(-0.0007, 1e-6));
    CHECK_THAT(found.Fx, WithinRel(known.Fx, 1e-8));
    CHECK_THAT(found.Fy, WithinRel(known.Fy, 1e-6));
}

TEST_CASE("FASTSIM refuses a force that friction cannot carry", "[fastsim]") {
    Rolling asked;
    asked.force.Fx = 0.8 * bound;
    asked.force.Fy = 0.7 * bound;
    CHECK_THROWS_AS(fastsim(window(contact, 5), contact, mu, asked), InvalidArgument);
    CHECK_THROWS_AS(fastsim(window(contact, 5), contact, 0, asked), InvalidArgument);
}

TEST_CASE("FASTSIM without friction slips everywhere, with the rigid slip", "[fastsim]") {
    const auto result = fastsim(window(contact, 5), contact, 0, rolling(0.001, 0.002, 0));
    CHECK(result.Fx == 0);
    CHECK(*result.frictional_power == 0);
    CHECK(result.element_division[12] == ElementState::slip);
    CHECK_THAT(result.slip_x[12], WithinRel(0.001, 1e-9));
    CHECK_THAT(result.slip_y[12], WithinRel(0.002, 1e-9));
}

TEST_CASE("FASTSIM without motion adheres, without contact does nothing", "[fastsim]") {
    const auto still = fastsim(window(contact, 5), contact, mu, rolling(0, 0, 0));
    CHECK(still.Fx == 0);
    CHECK(still.adhesion_area > 0.999 * contact.area());
    CHECK(still.element_division[12] == ElementState::adhesion);
    const auto nothing = fastsim(window(contact, 5), {{0, 0}, 0, steel}, mu, rolling(0.001, 0, 0));
    CHECK(nothing.Fx == 0);
    CHECK(nothing.element_division[12] == ElementState::exterior);
    CHECK_THROWS_AS(fastsim(window(contact, 5), contact, mu, {}, {3, 10}), InvalidArgument);
}
