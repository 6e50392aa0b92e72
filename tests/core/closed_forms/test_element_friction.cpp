#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

#include "closed_forms/elements/printed_coefficients.hpp"
#include "closed_forms/elements/rolling_theory.hpp"
#include "contactd/error.hpp"
#include "contactd/solve_contact.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;
constexpr Material steel{82000, 0.28};

struct Creepage {
    double xi, eta, phi;
};

ContactProblem rolling_ellipse(Model model, const SemiAxes& axes, double Fn, const Creepage& creepage, int nx, int ny) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(nx, ny, 2.2 * axes.a / nx, 2.2 * axes.b / ny);
    problem.bodies = Bodies::of({steel, steel});
    problem.model = model;
    problem.gap = axes;
    problem.Fn = Fn;
    problem.friction = FrictionLaw{{0.3}, {}};
    Rolling rolling;
    rolling.xi = creepage.xi;
    rolling.eta = creepage.eta;
    rolling.phi = creepage.phi;
    problem.motion = rolling;
    if (model == Model::fastsim) problem.simplified.on_elements = true;
    return problem;
}

ContactProblem given_case(Model model) {
    ContactProblem problem = rolling_ellipse(model, {6, 4}, 5e4, {0.0015, -8e-4, 2e-4}, 66, 44);
    problem.simplified.coefficients = CreepageCoefficients::printed;
    return problem;
}

ContactSolution solved(const ContactProblem& problem) {
    Observer observer;
    return solve_contact(problem, {}, observer);
}

void check(const Forces& forces, double Fx, double Fy, double Mz, double error) {
    CHECK_THAT(forces.Fx, WithinRel(Fx, error));
    CHECK_THAT(forces.Fy, WithinRel(Fy, error));
    CHECK_THAT(forces.Mz, WithinRel(Mz, error));
}

Rolling& motion_of(ContactProblem& problem) {
    return std::get<Rolling>(problem.motion);
}

}  // namespace

TEST_CASE("Printed coefficients are interpolated in lines and in the inverse of columns", "[elements]") {
    const KalkerCoefficients C = printed_coefficients(1.5, 0.28);
    CHECK_THAT(C.C11, WithinAbs(4.72407473, 1e-8));
    CHECK_THAT(C.C22, WithinAbs(4.36042394, 1e-8));
    CHECK_THAT(C.C23, WithinAbs(2.06999439, 1e-8));
}

TEST_CASE("Printed coefficients are near those that are computed", "[elements]") {
    const double ratio =
        GENERATE(0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.25, 1.4, 1.7, 2.0, 2.5, 3.3, 5.0, 10.0);
    const double nu = GENERATE(0.0, 0.25, 0.5);
    CAPTURE(ratio, nu);
    const KalkerCoefficients printed = printed_coefficients(ratio, nu), computed = kalker_coefficients(ratio, nu);
    CHECK_THAT(printed.C11, WithinRel(computed.C11, 0.03));
    CHECK_THAT(printed.C22, WithinRel(computed.C22, 0.03));
    CHECK_THAT(printed.C23, WithinRel(computed.C23, 0.06));
}

TEST_CASE("FASTSIM on elements has given forces", "[elements]") {
    ContactProblem problem = given_case(Model::fastsim);
    check(solved(problem).forces, -9580.6915, 1418.27362, -8629.06747, 1e-8);
    problem.simplified.bound = TractionBound::elliptic;
    check(solved(problem).forces, -10114.8965, 1679.99328, -10227.4825, 1e-8);
    problem.simplified.slope.k0 = 0.5;
    check(solved(problem).forces, -6354.15105, 1195.74451, -7660.04199, 1e-8);
}

TEST_CASE("FaStrip has given forces", "[elements]") {
    check(solved(given_case(Model::fastrip)).forces, -9967.73954, 1292.53577, -11464.8831, 1e-8);
}

TEST_CASE("Polach's model has given forces, and no tractions", "[elements]") {
    const ContactSolution solution = solved(given_case(Model::polach));
    CHECK_THAT(solution.forces.Fx, WithinRel(-9881.13306, 1e-8));
    CHECK_THAT(solution.forces.Fy, WithinRel(3415.5775, 1e-8));
    CHECK(solution.forces.Mz == 0);
    CHECK(solution.slip_x.empty());
    for (const double p : solution.traction_x) CHECK(p == 0);
}

TEST_CASE("A reduced slope has given values", "[elements]") {
    RollingTheory theory;
    theory.axes = theory.counted = {6, 4};
    theory.C.C11 = 4.6;
    theory.G = 82000;
    theory.Fn = 5e4;
    theory.settings.slope = {0.6, 0.1, 0.8};
    const double k = slope_factor(theory, FastsimCreepages<double>{0.004, 0, 0}, 0.3);
    CHECK_THAT(k, WithinAbs(0.342709677, 1e-9));
}

TEST_CASE("A public case of FASTSIM with blended flexibilities and spin ahead has its printed digits", "[elements]") {
    ContactProblem problem = rolling_ellipse(Model::fastsim, {8, 4}, 82000, {0, -6.25e-4, 6.25e-4}, 44, 44);
    problem.simplified.coefficients = CreepageCoefficients::printed;
    problem.simplified.blended = true;
    motion_of(problem).spin_offset = 1.0 / 6;
    const double bound = 0.3 * 82000;
    const ContactSolution parabolic = solved(problem);
    CHECK_THAT(parabolic.forces.Fy / bound, WithinAbs(-0.6118, 5e-5));
    CHECK_THAT(parabolic.forces.Mz, WithinAbs(-39000, 5));
    problem.simplified.bound = TractionBound::elliptic;
    CHECK_THAT(solved(problem).forces.Fy / bound, WithinAbs(-0.6016, 5e-5));
}

TEST_CASE("Public cases of FaStrip have their printed digits", "[elements]") {
    const int n = GENERATE(44, 220);
    ContactProblem problem = rolling_ellipse(Model::fastrip, {8, 4}, 82000, {0, -6.25e-4, 6.25e-4}, n, n);
    problem.simplified.coefficients = CreepageCoefficients::printed;
    problem.simplified.blended = true;
    motion_of(problem).spin_offset = 1.0 / 6;
    const Forces forces = solved(problem).forces;
    CHECK_THAT(forces.Fy / (0.3 * 82000), WithinAbs(n == 44 ? -0.6435 : -0.6442, 5e-5));
    CHECK_THAT(forces.Mz, WithinAbs(n == 44 ? -48160 : -47570, 5));
}

TEST_CASE("Friction that falls has one coefficient in all of the contact, by given forces of a traction curve",
          "[elements]") {
    const auto [xi, share] =
        GENERATE(std::pair(1e-5, 3.526e-3), std::pair(0.007, 0.7441), std::pair(0.05, 0.7999), std::pair(0.25, 0.4877));
    // Uses the ellipse of examples/tractcurv, series 4: 6.303 mm along and 12.607 mm across.
    ContactProblem problem = rolling_ellipse(Model::fastsim, {6.3034, 12.607}, 1.06e5, {xi, 0, 0}, 48, 44);
    problem.simplified.slope = {0.54, 0.02, 0.62};
    problem.friction = FrictionLaw{{0.36}, KineticFriction{SlipLaw::exponential, 0.1368, 990 / std::log(2)}};
    motion_of(problem).velocity = 10000;
    CHECK_THAT(-solved(problem).forces.Fx / (0.36 * 1.06e5), WithinRel(share, 0.02));
}

TEST_CASE("Simplified models have Kalker's forces for small creepages", "[elements]") {
    const Model model = GENERATE(Model::fastsim, Model::fastrip, Model::polach);
    const SemiAxes axes = GENERATE(SemiAxes{6, 4}, SemiAxes{3, 5});
    const double chi = GENERATE(0.0, pi / 2, pi, -pi / 2);
    const SemiAxes rolling = std::abs(std::cos(chi)) > 0.5 ? axes : SemiAxes{axes.b, axes.a};
    const KalkerCoefficients C = kalker_coefficients(rolling.a / rolling.b, steel.nu);
    const double area = steel.G * axes.a * axes.b;
    const double error = model == Model::polach ? 1e-6 : model == Model::fastsim ? 0.02 : 0.05;
    ContactProblem problem = rolling_ellipse(model, axes, 5e4, {}, 201, 201);
    Rolling& motion = motion_of(problem);
    motion.chi = chi;
    motion.xi = 1e-9 * std::cos(chi);
    motion.eta = 1e-9 * std::sin(chi);
    Forces forces = solved(problem).forces;
    CHECK_THAT(forces.Fx * std::cos(chi) + forces.Fy * std::sin(chi), WithinRel(-1e-9 * area * C.C11, error));
    motion.xi = -1e-9 * std::sin(chi);
    motion.eta = 1e-9 * std::cos(chi);
    forces = solved(problem).forces;
    CHECK_THAT(forces.Fy * std::cos(chi) - forces.Fx * std::sin(chi), WithinRel(-1e-9 * area * C.C22, error));
    motion.xi = motion.eta = 0;
    motion.phi = 1e-11;
    forces = solved(problem).forces;
    if (model == Model::fastrip) return;  // spin alone causes no lateral force, to first order
    CHECK_THAT(forces.Fy * std::cos(chi) - forces.Fx * std::sin(chi),
               WithinRel(-1e-11 * area * std::sqrt(axes.a * axes.b) * C.C23, error));
}

TEST_CASE("A reduced slope makes forces of small creepages as much smaller", "[elements]") {
    const Model model = GENERATE(Model::fastsim, Model::fastrip);
    ContactProblem problem = rolling_ellipse(model, {6, 4}, 5e4, {1e-9, 0, 0}, 101, 101);
    const double all = solved(problem).forces.Fx;
    problem.simplified.slope = {0.4, 0.1, 0.5};
    CHECK_THAT(solved(problem).forces.Fx, WithinRel(0.4 * all, 1e-4));
}

TEST_CASE("Simplified models carry mu Fn against large creepages", "[elements]") {
    const Model model = GENERATE(Model::fastsim, Model::fastrip, Model::polach);
    const double angle = GENERATE(0.0, 0.7, 2.5);
    const ContactSolution solution =
        solved(rolling_ellipse(model, {6, 4}, 5e4, {10 * std::cos(angle), 10 * std::sin(angle), 0}, 66, 44));
    CHECK_THAT(std::hypot(solution.forces.Fx, solution.forces.Fy), WithinRel(15000.0, 4e-3));
    // FASTSIM in whole steps slips along (xi/L1, eta/L2).
    CHECK_THAT(solution.forces.Fx, WithinAbs(-15000 * std::cos(angle), 500));
    CHECK_THAT(solution.forces.Fy, WithinAbs(-15000 * std::sin(angle), 500));
    CHECK_THAT(*solution.frictional_power, WithinRel(150000.0, 1e-2));
}

TEST_CASE("The mirror image of rolling has the mirror image of forces", "[elements]") {
    const Model model = GENERATE(Model::fastsim, Model::fastrip, Model::polach);
    const Forces one = solved(rolling_ellipse(model, {6, 4}, 5e4, {0.001, 5e-4, 1e-4}, 66, 44)).forces;
    const Forces other = solved(rolling_ellipse(model, {6, 4}, 5e4, {0.001, -5e-4, -1e-4}, 66, 44)).forces;
    CHECK_THAT(other.Fx, WithinRel(one.Fx, 1e-12));
    CHECK_THAT(other.Fy, WithinRel(-one.Fy, 1e-12));
    CHECK_THAT(other.Mz, WithinRel(-one.Mz, 1e-12) || WithinAbs(0, 0));
}

TEST_CASE("Rolling backwards is rolling that is rotated by half a turn", "[elements]") {
    const Model model = GENERATE(Model::fastsim, Model::fastrip, Model::polach);
    ContactProblem problem = rolling_ellipse(model, {6, 4}, 5e4, {0.001, 5e-4, 1e-4}, 66, 44);
    const Forces one = solved(problem).forces;
    motion_of(problem).chi = pi;
    motion_of(problem).xi *= -1;
    motion_of(problem).eta *= -1;
    const Forces other = solved(problem).forces;
    CHECK_THAT(other.Fx, WithinRel(-one.Fx, 1e-12));
    CHECK_THAT(other.Fy, WithinRel(-one.Fy, 1e-12));
    CHECK_THAT(other.Mz, WithinRel(one.Mz, 1e-12) || WithinAbs(0, 0));
}

TEST_CASE("FASTSIM on small elements comes to FASTSIM on its own slices", "[elements]") {
    ContactProblem problem = rolling_ellipse(Model::fastsim, {6, 4}, 5e4, {0.0015, -8e-4, 2e-4}, 801, 401);
    const Forces elements = solved(problem).forces;
    problem.simplified.on_elements = false;
    const Forces slices = solved(problem).forces;
    CHECK_THAT(elements.Fx, WithinAbs(slices.Fx, 5e-3 * 15000));
    CHECK_THAT(elements.Fy, WithinAbs(slices.Fy, 5e-3 * 15000));
    CHECK_THAT(elements.Mz, WithinAbs(slices.Mz, 5e-3 * 15000 * std::sqrt(24)));
}

TEST_CASE("FaStrip of wide contacts without spin is Carter's in each strip", "[elements]") {
    ContactProblem problem = rolling_ellipse(Model::fastrip, {1, 30}, 5e4, {}, 401, 41);
    const KalkerCoefficients C = kalker_coefficients(1.0 / 30, steel.nu);
    const double p0 = 1.5 * 5e4 / (pi * 30);
    const double full = 0.3 * p0 * pi * pi / (2 * steel.G * C.C11);  // d is half of the strip of a
    motion_of(problem).xi = 0.5 * full;
    const ContactSolution solution = solved(problem);
    const auto row = static_cast<std::size_t>(20) * 401;
    int adhesion = 0, all = 0;
    for (std::size_t i = row; i < row + 401; ++i) {
        all += solution.element_division[i] != ElementState::exterior;
        adhesion += solution.element_division[i] == ElementState::adhesion;
    }
    CHECK_THAT(static_cast<double>(adhesion) / all, WithinAbs(0.5, 0.01));
}

TEST_CASE("Prescribed forces are found by simplified models on elements", "[elements]") {
    const Model model = GENERATE(Model::fastsim, Model::polach);
    ContactProblem problem = rolling_ellipse(model, {6, 4}, 5e4, {0.001, 5e-4, 1e-4}, 66, 44);
    problem.simplified.coefficients = CreepageCoefficients::printed;
    const Forces forces = solved(problem).forces;
    motion_of(problem).force = {forces.Fx, forces.Fy};
    motion_of(problem).xi = motion_of(problem).eta = 0;
    const ContactSolution found = solved(problem);
    CHECK(found.converged());
    CHECK_THAT(std::get<Rolling>(*found.motion).xi, WithinRel(0.001, 1e-5));
    CHECK_THAT(std::get<Rolling>(*found.motion).eta, WithinRel(5e-4, 1e-5));
}

TEST_CASE("Derivatives by the motion are those of differences", "[elements]") {
    const Model model = GENERATE(Model::fastsim, Model::fastrip, Model::polach);
    ContactProblem problem = rolling_ellipse(model, {6, 4}, 5e4, {0.001, 5e-4, 1e-4}, 66, 44);
    if (model != Model::polach) problem.simplified.slope = {0.8, 0.3, 0.5};
    problem.derivatives = true;
    const auto derivatives = solved(problem).derivatives;
    REQUIRE(derivatives);
    problem.derivatives = false;
    const auto force_at = [&](double xi, double eta, double phi) {
        motion_of(problem).xi = xi;
        motion_of(problem).eta = eta;
        motion_of(problem).phi = phi;
        return solved(problem).forces;
    };
    const double h = 1e-10;
    const auto difference = [&](const Forces& more, const Forces& less) {
        return std::pair((more.Fx - less.Fx) / (2 * h), (more.Fy - less.Fy) / (2 * h));
    };
    const auto by_xi = difference(force_at(0.001 + h, 5e-4, 1e-4), force_at(0.001 - h, 5e-4, 1e-4));
    const auto by_eta = difference(force_at(0.001, 5e-4 + h, 1e-4), force_at(0.001, 5e-4 - h, 1e-4));
    const auto by_phi = difference(force_at(0.001, 5e-4, 1e-4 + h), force_at(0.001, 5e-4, 1e-4 - h));
    CHECK_THAT(*derivatives->Fx->xi, WithinRel(by_xi.first, 1e-4));
    CHECK_THAT(*derivatives->Fy->xi, WithinRel(by_xi.second, 1e-4));
    CHECK_THAT(*derivatives->Fx->eta, WithinRel(by_eta.first, 1e-4));
    CHECK_THAT(*derivatives->Fy->eta, WithinRel(by_eta.second, 1e-4));
    CHECK_THAT(*derivatives->Fx->phi, WithinRel(by_phi.first, 1e-4));
    CHECK_THAT(*derivatives->Fy->phi, WithinRel(by_phi.second, 1e-4));
}

TEST_CASE("Options that are not those of the model are refused", "[elements]") {
    ContactProblem problem = given_case(Model::polach);
    problem.simplified.slope.k0 = 0.5;
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("fastsim and fastrip") && ContainsSubstring("polach"));
    problem = given_case(Model::fastsim);
    problem.simplified.k_slip = 0.5;
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("model polach"));
    problem = given_case(Model::fastrip);
    problem.simplified.bound = TractionBound::elliptic;
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("model fastsim"));
    problem = given_case(Model::polach);
    problem.simplified.k_adhesion = 0.5;
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("k_slip <= k_adhesion"));
}

TEST_CASE("Simplified models refuse what is not steady rolling along an axis", "[elements]") {
    const Model model = GENERATE(Model::fastsim, Model::fastrip, Model::polach);
    ContactProblem problem = given_case(model);
    motion_of(problem).chi = 0.3;
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("axis"));
    motion_of(problem).chi = 0;
    motion_of(problem).kind = RollingKind::transient;
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("transient"));
    problem.motion = Shift{{0.001, 0}};
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("is a shift"));
}

TEST_CASE("Friction of all of a contact has no memory", "[elements]") {
    ContactProblem problem = given_case(GENERATE(Model::fastsim, Model::fastrip, Model::polach));
    problem.friction->kinetic = KineticFriction{SlipLaw::exponential, 0.1, 1000};
    CHECK_NOTHROW(solved(problem));
    problem.friction->kinetic->memory = FrictionMemory{0.01, 1};
    CHECK_THROWS_WITH(solved(problem), ContainsSubstring("friction.kinetic.memory"));
}

TEST_CASE("The one coefficient of falling friction is answered", "[elements]") {
    ContactProblem problem = given_case(GENERATE(Model::fastsim, Model::fastrip, Model::polach));
    CHECK(solved(problem).friction_coefficient.empty());
    problem.friction->kinetic = KineticFriction{SlipLaw::exponential, 0.1, 30};
    motion_of(problem).velocity = 20000;
    const Rolling& rolling = motion_of(problem);
    const double mu = problem.friction->mu[0], v = 20000 * std::hypot(rolling.xi, rolling.eta);
    const double fallen = friction_coefficient(*problem.friction->kinetic, mu, v);
    REQUIRE(fallen < 0.9 * mu);
    const ContactSolution solution = solved(problem);
    REQUIRE(solution.friction_coefficient.size() == problem.grid.size());
    for (std::size_t i = 0; i < problem.grid.size(); ++i)
        CHECK(solution.friction_coefficient[i] ==
              (solution.element_division[i] == ElementState::exterior ? mu : fallen));
    problem.motion = Rolling{};
    CHECK(solved(problem).friction_coefficient == std::vector<double>(problem.grid.size(), mu));
}

TEST_CASE("Spin that is too much for strips, and slopes that rise, are told", "[elements]") {
    ContactProblem problem = rolling_ellipse(Model::fastrip, {6, 4}, 5e4, {0.001, 0, 0.003}, 66, 44);
    auto warnings = solved(problem).warnings;
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], ContainsSubstring("strip theory"));
    motion_of(problem).phi = 0;
    problem.simplified.slope = {1.5, 2, 0.1};
    CHECK(solved(problem).warnings.size() == 2);
}
