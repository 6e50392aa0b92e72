#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contact/tangential/prescribed_force.hpp"
#include "random_friction.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double largest_force = 3, scale = 0.01;

// Models a sphere's force, opposite to the slip, with an exponent for its shape, and counts its evaluations.
struct Sphere {
    double exponent = 1.5, centre_x = 0, centre_y = 0;
    int calls = 0;
    double last_tolerance = 0;

    ForcesAtSlip operator()(double wx, double wy, double tolerance) {
        ++calls;
        last_tolerance = tolerance;
        const double x = wx - centre_x, y = wy - centre_y, size = std::hypot(x, y);
        if (size == 0) return {0, 0, true};
        const double force = largest_force * (1 - std::pow(std::max(1 - size / scale, 0.0), exponent));
        return {-force * x / size, -force * y / size, true};
    }
};

RigidSlipForForces find(const PrescribedForces& prescribed, Sphere& sphere,
                        const SolverSettings& settings = {1e-6, 60}) {
    Observer observer;
    return find_rigid_slip(prescribed, settings, std::ref(sphere), observer);
}

PrescribedForces forces(std::optional<double> Fx, std::optional<double> Fy) {
    PrescribedForces prescribed;
    prescribed.Fx = Fx;
    prescribed.Fy = Fy;
    prescribed.largest = largest_force;
    prescribed.scale = scale;
    return prescribed;
}

// Models a contact whose bound is a hemisphere.
RandomFriction hemisphere() {
    const Grid grid = Grid::of_elements(20, 18, 0.1, 0.1);
    RandomFriction problem{grid, half_space_pair(grid, {200, 0.3}), {}, {}, {}, {}};
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix)
            problem.bound.push_back(1.5 *
                                    std::sqrt(std::max(0.7 - std::pow(grid.x(ix), 2) - std::pow(grid.y(iy), 2), 0.0)));
    return problem;
}

}  // namespace

TEST_CASE("the rigid slip for a force is found in few calls where the shape is the expected one", "[force]") {
    const double part = GENERATE(1e-4, 0.3, 0.9, 0.999), angle = GENERATE(0.0, 2.2);
    Sphere sphere;
    const auto found =
        find(forces(part * largest_force * std::cos(angle), part * largest_force * std::sin(angle)), sphere);
    CHECK(found.evidence.converged);
    CHECK(found.evidence.residual <= 1e-6);
    CHECK(found.evidence.iterations == sphere.calls);
    CHECK(sphere.calls <= 3);
    CHECK(sphere.last_tolerance <= 1e-6);
    CHECK_THAT(std::hypot(found.wx, found.wy), WithinRel(scale * (1 - std::pow(1 - part, 2.0 / 3)), 1e-4));
}

TEST_CASE("the rigid slip is found where the shape is another and the estimate bad", "[force]") {
    Sphere sphere;
    sphere.exponent = GENERATE(1.0, 3.0, 6.0);
    sphere.centre_x = GENERATE(0.0, -0.05);
    PrescribedForces prescribed = forces(-0.7 * largest_force, 0.2 * largest_force);
    prescribed.wx = GENERATE(0.0, 0.1, -1.0);
    prescribed.scale = scale * GENERATE(0.1, 1.0, 10.0);
    CAPTURE(sphere.exponent, sphere.centre_x, prescribed.wx, prescribed.scale);
    const auto found = find(prescribed, sphere);
    CHECK(found.evidence.converged);
    const ForcesAtSlip reached = sphere(found.wx, found.wy, 0);
    CHECK_THAT(reached.Fx, WithinAbs(-0.7 * largest_force, 1e-6 * largest_force));
    CHECK_THAT(reached.Fy, WithinAbs(0.2 * largest_force, 1e-6 * largest_force));
}

TEST_CASE("a component without a force keeps its rigid slip", "[force]") {
    Sphere sphere;
    PrescribedForces prescribed = forces({}, 0.9 * largest_force);
    prescribed.wx = 0.7 * scale;
    const auto found = find(prescribed, sphere);
    CHECK(found.evidence.converged);
    CHECK(found.wx == prescribed.wx);
    CHECK_THAT(sphere(found.wx, found.wy, 0).Fy, WithinAbs(0.9 * largest_force, 1e-6 * largest_force));
}

TEST_CASE("forces below the largest are reached, at it every slip would do and they are refused", "[force]") {
    Sphere sphere;
    CHECK(find(forces(-(1 - 1e-5) * largest_force, 0), sphere).evidence.converged);
    CHECK_THROWS_AS(find(forces(-largest_force, 0), sphere), InvalidArgument);
    CHECK_THROWS_AS(find(forces({}, (1 - 1e-7) * largest_force), sphere), InvalidArgument);
    PrescribedForces beyond = forces(-largest_force, 0.01 * largest_force);
    beyond.field = "friction.rolling.force";
    try {
        find(beyond, sphere);
        FAIL("no error");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "friction.rolling.force");
        CHECK(std::string(error.what()).find("At 3 N, the sum of the friction bounds") != std::string::npos);
    }
    CHECK_THROWS_AS(find(forces(std::nan(""), {}), sphere), InvalidArgument);
}

TEST_CASE("no force and no bound ask for nothing", "[force]") {
    Sphere sphere;
    PrescribedForces none = forces(0, 0);
    none.largest = GENERATE(0.0, largest_force);
    const auto found = find(none, sphere);
    CHECK(found.evidence.converged);
    CHECK(found.wx == 0);
    CHECK(found.wy == 0);
}

TEST_CASE("a force that cannot be met says so", "[force]") {
    // The solver's force has noise above the tolerance.
    int calls = 0;
    const SolveForForces noisy = [&](double wx, double, double) {
        return ForcesAtSlip{-largest_force * wx / scale + 1e-3 * (++calls % 2), 0, true};
    };
    Observer observer;
    const auto found = find_rigid_slip(forces(1, {}), {1e-6, 25}, noisy, observer);
    CHECK_FALSE(found.evidence.converged);
    CHECK(calls <= 26);

    const SolveForForces unconverged = [](double wx, double, double) {
        return ForcesAtSlip{-largest_force * wx / scale, 0, false};
    };
    CHECK_FALSE(find_rigid_slip(forces(1, {}), {1e-6, 25}, unconverged, observer).evidence.converged);
}

TEST_CASE("forces give back the shift that caused them", "[force][tangential]") {
    RandomFriction problem = hemisphere();
    problem.motion = {0.002, -0.001, GENERATE(0.0, 0.003), {}, {}};
    const auto shifted = solve(problem);
    double Fx = 0, Fy = 0;
    for (std::size_t i = 0; i < problem.bound.size(); ++i) {
        Fx += shifted.tangential.traction_x[i];
        Fy += shifted.tangential.traction_y[i];
    }
    const double unit = problem.grid.element_area() / problem.largest_force();
    problem.motion = {0, 0, problem.motion.turn, Fx * unit, Fy * unit};
    const auto forced = solve(problem);
    REQUIRE(forced.converged());
    CHECK(forced.tangential.element_division == shifted.tangential.element_division);
    const std::size_t corner = 0;  // on the grid without history, rigid slip less rotation equals the shift
    CHECK_THAT(forced.rigid_x[corner], WithinAbs(shifted.rigid_x[corner], 1e-7));
    CHECK_THAT(forced.rigid_y[corner], WithinAbs(shifted.rigid_y[corner], 1e-7));
}
