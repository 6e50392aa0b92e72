#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

#include "contact/tangential/friction_law.hpp"
#include "contact_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double mu_s = 0.5, mu_k = 0.2, v_c = 40;

// Represents an element whose slip velocity decreases with its bound.
struct Slider {
    double drive, stiffness;
    void operator()(std::span<const double> bound, std::span<double> slip_velocity) const {
        for (std::size_t i = 0; i < bound.size(); ++i) slip_velocity[i] = std::max(drive - stiffness * bound[i], 0.0);
    }
};

/// Alternates between solving and updating, like boundary elements; `solve` writes slip velocities for bounds.
template <class Solve>
SolverEvidence iterate(SlipLawIteration& law, const Values& pressure, const SolverSettings& settings,
                       const Solve& solve) {
    Values bound(pressure.size()), slip_velocity(pressure.size());
    SolverEvidence evidence;
    while (!evidence.converged && evidence.iterations < settings.max_iterations) {
        for (std::size_t i = 0; i < bound.size(); ++i) bound[i] = law.mu()[i] * pressure[i];
        solve(bound, slip_velocity);
        ++evidence.iterations;
        evidence.residual = law.follow(slip_velocity, pressure);
        evidence.converged = evidence.residual <= settings.tolerance;
    }
    return evidence;
}

}  // namespace

TEST_CASE("friction falls from the static to the kinetic coefficient", "[friction_law]") {
    const SlipLaw law = GENERATE(SlipLaw::linear, SlipLaw::exponential);
    const KineticFriction kinetic{law, mu_k, v_c};
    CHECK(friction_coefficient(kinetic, mu_s, 0) == mu_s);
    CHECK_THAT(friction_coefficient(kinetic, mu_s, 1e6), WithinRel(mu_k, 1e-12));
    double last = mu_s;
    for (double v = 1; v < 3 * v_c; v += 1) {
        const double mu = friction_coefficient(kinetic, mu_s, v);
        CHECK(mu <= last);
        CHECK(mu >= mu_k);
        last = mu;
    }
}

TEST_CASE("laws have their value at the characteristic velocity", "[friction_law]") {
    CHECK_THAT(friction_coefficient({SlipLaw::linear, mu_k, v_c}, mu_s, 0.5 * v_c), WithinRel(0.35, 1e-14));
    CHECK(friction_coefficient({SlipLaw::linear, mu_k, v_c}, mu_s, v_c) == mu_k);
    CHECK_THAT(friction_coefficient({SlipLaw::exponential, mu_k, v_c}, mu_s, v_c),
               WithinRel(mu_k + 0.3 * std::exp(-1), 1e-14));
}

TEST_CASE("laws that make no sense are refused by the name of their field", "[friction_law]") {
    const Values mu{mu_s, 0.4};
    const auto field = [&](const KineticFriction& kinetic) -> std::string {
        try {
            validate(kinetic, mu);
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return {};
    };
    CHECK(field({SlipLaw::linear, mu_k, v_c}).empty());
    CHECK(field({SlipLaw::linear, 0.4, v_c}).empty());
    CHECK(field({SlipLaw::linear, mu_k, 0}) == "friction.kinetic.slip_velocity");
    CHECK(field({SlipLaw::linear, mu_k, -1}) == "friction.kinetic.slip_velocity");
    CHECK(field({SlipLaw::linear, mu_k, std::numeric_limits<double>::infinity()}) == "friction.kinetic.slip_velocity");
    CHECK(field({SlipLaw::linear, 0.45, v_c}) == "friction.kinetic.mu");
    CHECK(field({SlipLaw::linear, -0.1, v_c}) == "friction.kinetic.mu");
    CHECK(field({SlipLaw::linear, std::nan(""), v_c}) == "friction.kinetic.mu");
}

TEST_CASE("bounds and slip velocities agree in the end", "[friction_law]") {
    const KineticFriction kinetic{GENERATE(SlipLaw::linear, SlipLaw::exponential), mu_k, v_c};
    const double stiffness = GENERATE(1.0, 50.0, 120.0);  // the last one overshoots without relaxation
    const Values pressure{1, 0.7, 0.3, 0}, mu(4, mu_s);
    const Slider slider{stiffness * 0.45, stiffness};
    SlipLawIteration law(kinetic, mu);
    const auto evidence = iterate(law, pressure, {1e-9, 200}, slider);
    REQUIRE(evidence.converged);
    CHECK(evidence.residual <= 1e-9);
    for (std::size_t i = 0; i < 3; ++i) {
        const double v = std::max(slider.drive - slider.stiffness * law.mu()[i] * pressure[i], 0.0);
        CHECK_THAT(law.mu()[i], WithinAbs(friction_coefficient(kinetic, mu_s, v), 1e-7));
    }
}

TEST_CASE("equal coefficients need one solve", "[friction_law]") {
    SlipLawIteration law({SlipLaw::linear, mu_s, v_c}, Values(2, mu_s));
    const auto evidence = iterate(law, Values{1, 2}, {}, Slider{10, 1});
    CHECK(evidence.converged);
    CHECK(evidence.iterations == 1);
}

TEST_CASE("friction without a steady answer says so", "[friction_law]") {
    // It slips with high friction and sticks with low friction, so no coefficient is consistent with its slip.
    const auto contrary = [](std::span<const double> bound, std::span<double> slip_velocity) {
        for (std::size_t i = 0; i < bound.size(); ++i) slip_velocity[i] = bound[i] >= 0.35 ? 1e3 : 0;
    };
    SlipLawIteration law({SlipLaw::linear, mu_k, v_c}, Values(1, mu_s));
    const auto evidence = iterate(law, Values{1}, {1e-6, 50}, contrary);
    CHECK_FALSE(evidence.converged);
    CHECK(evidence.iterations == 50);
    CHECK(evidence.residual > 0.1);
}

TEST_CASE("no contact has nothing to follow", "[friction_law]") {
    SlipLawIteration law({SlipLaw::exponential, mu_k, v_c}, Values(3, mu_s));
    CHECK(iterate(law, Values(3), {}, Slider{10, 1}).converged);
}
