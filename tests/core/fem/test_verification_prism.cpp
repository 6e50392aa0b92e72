// Compares influence coefficients on the prisms of Mesh2 with reference values of MFEM 4.7 (G=82000, nu=0.28, h=0.8 mm,
// u = 0 on the far faces).
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contact/contact_cases.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/solve_contact.hpp"
#include "fem_specs.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double target = 0.01;  // of the paper, equation (3.1)

IcEvidence build(const IcSpec& spec) {
    Observer observer;
    return fem::build_ic_table(spec, observer).evidence;
}

}  // namespace

// Slow: it uses meshes of prisms with up to 131811 unknowns.
TEST_CASE("Prisms meet the reference with diagonals that run outward", "[fem][prism][verification][slow]") {
    struct Row {
        const char* preset;
        double L;
        long long elements, dofs;
        double zz;
    };
    const Row row = GENERATE(Row{"paper-mesh2-test2", 128, 4080, 54915, -3.4e-4},
                             Row{"paper-mesh2-test2", 256, 5168, 69147, +1.0e-3},
                             Row{"paper-mesh2-test3", 64, 9984, 131811, -2.28e-3});
    CAPTURE(row.preset, row.L);
    const IcEvidence evidence = build(paper_spec(row.preset, row.L));
    CHECK(evidence.elements == row.elements);
    CHECK(evidence.dofs == row.dofs);
    CHECK_THAT(evidence.errors.zz.value().origin, WithinRel(row.zz, 0.02));
}

TEST_CASE("The error of prisms depends on the direction of the diagonals", "[fem][prism][verification]") {
    IcSpec spec = paper_spec("paper-mesh2-test2", 128);
    spec.fem.diagonal = Diagonal::across;
    CHECK_THAT(build(spec).errors.zz.value().origin, WithinRel(-2.0e-3, 0.02));
}

// Long: it uses four blocks on fine meshes of prisms.
TEST_CASE("Every test on prisms reaches the target at the origin", "[fem][prism][verification][long]") {
    const auto [preset, L_over_h] = GENERATE(std::pair{"paper-mesh2-test1", 40}, std::pair{"paper-mesh2-test2", 40},
                                             std::pair{"paper-mesh2-test3", 40}, std::pair{"paper-mesh2-test2", 640});
    CAPTURE(preset, L_over_h);
    const IcEvidence evidence = build(paper_spec(preset, 0.8 * L_over_h));
    CHECK(std::abs(evidence.errors.zz.value().origin) < target);
    CHECK(std::abs(evidence.errors.xx.value().origin) < target);
    CHECK(std::abs(evidence.errors.yy.value().origin) < target);
}

// Long: it compares factorisation and iterations.
TEST_CASE("Both solvers find the same coefficients on prisms", "[fem][prism][verification][long]") {
    // If ill-conditioned matrices caused the plateau of Mesh2, as the paper states, they would not agree.
    IcSpec spec = paper_spec("paper-mesh2-test2", 512);
    Observer observer;
    spec.fem.solver = Solver::direct;
    const IcTable direct = fem::build_ic_table(spec, observer).table();
    spec.fem.solver = Solver::amg_pcg;
    const IcTable iterated = fem::build_ic_table(spec, observer).table();
    const double scale = direct(Axis::z, Axis::z, 0, 0);
    for (const Axis i : {Axis::x, Axis::y, Axis::z})
        for (const Axis j : {Axis::x, Axis::y, Axis::z})
            CHECK_THAT(iterated(i, j, 1, 2), WithinAbs(direct(i, j, 1, 2), 1e-6 * scale));
}

// Slow: it uses two blocks on fine meshes of prisms.
TEST_CASE("Far data free prisms from the size of the block", "[fem][prism][verification][slow]") {
    IcSpec spec = paper_spec("paper-mesh2-test2", 8);
    spec.fem.far_boundary = FarBoundary::half_space;
    const IcEvidence small = build(spec);
    CHECK(small.errors.zz.value().largest < target);
    CHECK(small.errors.xx.value().largest < target);
    CHECK(small.errors.yy.value().largest < target);
    spec.fem.L_over_h = 160;
    CHECK_THAT(small.errors.zz.value().origin, WithinAbs(build(spec).errors.zz.value().origin, 2e-4));
}

// Slow: it uses up to cubic elements.
TEST_CASE("The error of prisms falls with their order", "[fem][prism][verification][slow]") {
    const auto [order, largest] = GENERATE(std::pair{1, 0.1}, std::pair{2, 7e-3}, std::pair{3, 7e-4});
    CAPTURE(order);
    IcSpec spec = paper_spec("paper-mesh2-test2", 8);
    spec.fem.far_boundary = FarBoundary::half_space;
    spec.fem.order = order;
    const IcEvidence evidence = build(spec);
    for (const auto& error : {evidence.errors.zz, evidence.errors.xx, evidence.errors.yy}) {
        CHECK(error.value().largest < largest);
        CHECK(error.value().largest > largest / 2);
    }
}

// Long: it uses a factorised block, and contact on 160 x 160 elements.
TEST_CASE("The Cattaneo problem with coefficients on prisms is within the paper's errors",
          "[fem][prism][verification][long]") {
    const ContactProblem problem = test::cattaneo_problem(160);
    IcSpec spec = paper_spec("paper-mesh2-test2", 128);
    spec.material = problem.bodies.upper.material;
    spec.dx = spec.dy = problem.grid.dx;
    spec.nx = spec.ny = 160;
    spec.fem.L_over_h = 128 / spec.dx;
    // u = 0 at L = 128 mm alone increases both forces by 0.9 %.
    spec.fem.far_boundary = FarBoundary::half_space;
    spec.fem.solver = Solver::direct;
    Observer observer;
    IcTable body = fem::build_ic_table(spec, observer).table();
    for (double& value : body.values) value *= spec.dx / spec.material.G;
    const ContactSolution solution = solve_contact(problem, make_influence(problem, pair_of(body, body)), observer);
    REQUIRE(solution.converged());
    CHECK_THAT(solution.forces.Fn, WithinRel(9.195402, 0.01));
    CHECK_THAT(solution.forces.Fx, WithinRel(-3.2216, 0.003));
}
