// Tests the closed forms of reference.hpp for rolling and for loading histories.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "support/closed_forms.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi, mu = 0.3;
const MaterialPair steel_pair{{82000, 0.28}, {82000, 0.28}};
const auto line = reference::line_contact(steel_pair, 250, 2000);
const double full_creepage = mu * line.half_width / 250;  // Johnson (8.27)

// Returns the derivative of the displacement difference along x (plane strain), (1-nu)/(pi G) times the principal value
// of the integral of q/(x - s), for each body.
double stretch(const reference::Carter& carter, double x) {
    const int n = 20000;
    const double h = 4 * line.half_width / n;
    double integral = 0;
    for (int j = 0; j < n; ++j)  // sums points left and right of x in pairs
        integral += (reference::carter_traction(line, carter, mu, x - (j + 0.5) * h) -
                     reference::carter_traction(line, carter, mu, x + (j + 0.5) * h)) /
                    (j + 0.5);
    return -2 * (1 - 0.28) / (pi * 82000) * integral;
}

}  // namespace

TEST_CASE("line contact carries its force", "[reference]") {
    CHECK_THAT(line.pmax, WithinRel(line.half_width / (2 * 250 * steel_pair.normal_compliance()), 1e-12));
    CHECK_THAT(0.5 * pi * line.pmax * line.half_width, WithinRel(2000.0, 1e-12));
    CHECK(reference::line_contact(steel_pair, 250, 0).half_width == 0);
}

TEST_CASE("Carter's adhesion area stretches by the creepage and adds up to the force", "[reference]") {
    const double share = GENERATE(0.2, -0.5, 0.9);
    const auto carter = reference::carter_of_creepage(steel_pair, line, mu, share * full_creepage);
    CHECK_THAT(carter.adhesion_half, WithinRel((1 - std::abs(share)) * line.half_width, 1e-9));
    CHECK_THAT(carter.adhesion_centre + carter.adhesion_half, WithinRel(line.half_width, 1e-12));
    CHECK_THAT(stretch(carter, carter.adhesion_centre), WithinRel(carter.creepage, 1e-3));
    double force = 0;
    const double h = line.half_width / 1000;
    for (int j = -1000; j < 1000; ++j) force += h * reference::carter_traction(line, carter, mu, (j + 0.5) * h);
    CHECK_THAT(force, WithinRel(carter.force, 1e-3));
    CHECK(force * share < 0);
}

TEST_CASE("Carter's slip is against the traction", "[reference]") {
    const auto carter = reference::carter_of_creepage(steel_pair, line, mu, 0.4 * full_creepage);
    const double x = carter.adhesion_centre - carter.adhesion_half - 0.2 * line.half_width;
    CHECK(carter.creepage - stretch(carter, x) > 0);
    CHECK(reference::carter_traction(line, carter, mu, x) < 0);
}

TEST_CASE("Carter's force and creepage give each other", "[reference]") {
    const auto carter = reference::carter_of_creepage(steel_pair, line, mu, -0.3 * full_creepage);
    const auto back = reference::carter_of_force(steel_pair, line, mu, carter.force);
    CHECK_THAT(back.creepage, WithinRel(carter.creepage, 1e-12));
    CHECK_THAT(back.adhesion_half, WithinRel(carter.adhesion_half, 1e-12));
}

TEST_CASE("Carter's contact saturates", "[reference]") {
    const auto slip = reference::carter_of_creepage(steel_pair, line, mu, 2 * full_creepage);
    CHECK_THAT(slip.force, WithinRel(-mu * line.force, 1e-12));
    CHECK(slip.adhesion_half == 0);
    CHECK(reference::carter_of_creepage(steel_pair, line, mu, 0).force == 0);
}

TEST_CASE("linear rolling pushes against creepage, and sideways with spin", "[reference]") {
    const auto forces = reference::linear_rolling(steel_pair, {6, 4}, 1e-6, 2e-6, 1e-7);
    CHECK(forces.Fx < 0);
    CHECK(forces.Fy < 0);
    const auto spin = reference::linear_rolling(steel_pair, {6, 4}, 0, 0, 1e-7);
    CHECK(spin.Fx == 0);
    CHECK(spin.Fy < 0);
    CHECK(spin.Mz < 0);
    const auto lateral = reference::linear_rolling(steel_pair, {6, 4}, 0, 1e-7, 0);
    CHECK_THAT(lateral.Mz, WithinRel(-spin.Fy, 1e-12));  // C32 = -C23
}

TEST_CASE("an unloaded shift closes its loop", "[reference]") {
    const reference::Hertz hertz = reference::hertz(steel_pair, 50, 0.02);
    const double highest = 0.7 * mu * hertz.Fn;
    const double loaded = reference::cattaneo(steel_pair, hertz, mu, highest).rigid_shift;
    CHECK_THAT(reference::unloading_shift(steel_pair, hertz, mu, highest, highest), WithinRel(loaded, 1e-12));
    CHECK_THAT(reference::unloading_shift(steel_pair, hertz, mu, highest, -highest), WithinRel(-loaded, 1e-12));
    CHECK(reference::unloading_shift(steel_pair, hertz, mu, highest, 0) > 0.01 * loaded);  // a residual shift remains
}

TEST_CASE("full spin has the moment of its pressure", "[reference]") {
    const reference::Hertz hertz = reference::hertz(steel_pair, 50, 0.02);
    double moment = 0;
    const int n = 1000;
    for (int j = 0; j < n; ++j) {
        const double r = (j + 0.5) / n;
        moment += mu * hertz.pmax * std::sqrt(1 - r * r) * 2 * pi * r * r * std::pow(hertz.radius, 3) / n;
    }
    CHECK_THAT(reference::full_spin_moment(hertz, mu), WithinRel(moment, 1e-4));
}
