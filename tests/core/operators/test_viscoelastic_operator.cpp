#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "bodies/viscoelastic_influence.hpp"
#include "contact/contact_cases.hpp"
#include "contact/dense_operator.hpp"
#include "operators/viscoelastic/viscoelastic_operator.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using enum contactd::Axis;

namespace {

ContactProblem rolling_problem(int nx, int ny, double chi = 0) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(nx, ny, 0.5, 0.7);
    problem.bodies = {{{1143, 0.4}, Ics{}, Viscoelasticity{1.5, 2e-3}},
                      {{900, 0.2}, Ics{}, Viscoelasticity{0.5, 1e-2}}};
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.chi = chi, .velocity = 1000};
    return problem;
}

RollingTable table_of(const ContactProblem& problem) {
    const auto& rolling = std::get<Rolling>(problem.motion);
    return rolling_table({problem.bodies, rolling.velocity, std::cos(rolling.chi) > 0}, problem.grid);
}

void check_equal(const Values& computed, const Values& expected) {
    constexpr double rounding = 1e-18;  // error of components that are zero by symmetry
    for (std::size_t i = 0; i < computed.size(); ++i)
        CHECK_THAT(computed[i], WithinAbs(expected[i], 1e-13 * largest(expected) + rounding));
}

void check_against_dense_sums(const InfluenceOperator& influence, const DenseOperator& dense) {
    const std::size_t n = dense.size();
    REQUIRE(influence.size() == n);
    const Values px = random_values(n, 1), py = random_values(n, 2), pz = random_values(n, 3);
    Values ux(n), uy(n), uz(n), dense_x(n), dense_y(n), dense_z(n);
    influence.normal(pz, uz);
    dense.normal(pz, dense_z);
    check_equal(uz, dense_z);
    influence.tangential(px, py, ux, uy);
    dense.tangential(px, py, dense_x, dense_y);
    check_equal(ux, dense_x);
    check_equal(uy, dense_y);
    influence.normal_of_tangential(px, py, uz);
    dense.normal_of_tangential(px, py, dense_z);
    check_equal(uz, dense_z);
    influence.tangential_of_normal(pz, ux, uy);
    dense.tangential_of_normal(pz, dense_x, dense_y);
    check_equal(ux, dense_x);
    check_equal(uy, dense_y);
}

}  // namespace

TEST_CASE("products of bodies that creep equal dense sums", "[viscoelastic]") {
    const auto [nx, ny] = GENERATE(std::pair{1, 3}, std::pair{9, 1}, std::pair{8, 6}, std::pair{23, 5});
    const double chi = GENERATE(0.0, 3.14159265358979323846);
    CAPTURE(nx, ny, chi);
    const ContactProblem problem = rolling_problem(nx, ny, chi);
    const ContactInfluence influence = operators_of(problem, pair_table(problem));
    const DenseOperator dense{DenseMatrices(problem.grid.size(), 3, entries_of(table_of(problem), problem.grid))};
    check_against_dense_sums(*influence.current, dense);
    CHECK_FALSE(influence.current->is_symmetric());
    CHECK(influence.current->coupled());
    CHECK(influence.current->bytes() <= influence_bytes(problem.grid, problem.bodies));
}

TEST_CASE("boxes of bodies that creep are parts of the whole", "[viscoelastic]") {
    const ContactProblem problem = rolling_problem(16, 12), part = rolling_problem(7, 5);
    const ContactInfluence influence = operators_of(problem, pair_table(problem));
    const DenseOperator dense{DenseMatrices(part.grid.size(), 3, entries_of(table_of(part), part.grid))};
    check_against_dense_sums(*influence.current->boxes()->influence({3, 2, 7, 5}), dense);
}

TEST_CASE("on a coarser grid bodies that creep yield as much", "[viscoelastic]") {
    const ContactProblem problem = rolling_problem(40, 36);
    const ContactInfluence influence = operators_of(problem, pair_table(problem));
    const CoarserGrid* coarser = influence.current->coarser();
    REQUIRE(coarser != nullptr);
    Values p(problem.grid.size()), coarse_p(coarser->influence().size()), u(p.size()), coarse_u(coarse_p.size()),
        averaged(coarse_p.size());
    for (int iy = 8; iy < 28; ++iy)
        for (int ix = 10; ix < 30; ++ix) p[at(problem.grid, ix, iy)] = 1;
    coarser->average(p, coarse_p);
    influence.current->normal(p, u);
    coarser->average(u, averaged);
    coarser->influence().normal(coarse_p, coarse_u);
    for (std::size_t i = 0; i < averaged.size(); ++i)
        CHECK_THAT(coarse_u[i], WithinAbs(averaged[i], 1e-12 * largest(averaged)));
}

TEST_CASE("the preconditioner of bodies that creep is as good as that of elastic ones", "[viscoelastic]") {
    const double chi = GENERATE(0.0, 3.14159265358979323846);
    ContactProblem problem = rolling_problem(64, 48, chi), elastic = problem;
    // With fast creep, waves behind the grid matter little.
    problem.bodies.upper.viscoelastic->tau = 1e-3;
    problem.bodies.lower.viscoelastic->tau = 5e-4;
    for (Body* body : {&elastic.bodies.upper, &elastic.bodies.lower}) body->viscoelastic.reset();
    const std::size_t n = problem.grid.size();
    Values p(n);
    for (int iy = 18; iy < 30; ++iy)
        for (int ix = 24; ix < 40; ++ix) p[at(problem.grid, ix, iy)] = 1;
    struct Errors {
        double normal, tangential;
    };
    const auto errors = [&](const ContactProblem& of) {
        const ContactInfluence influence = operators_of(of, pair_table(of));
        Values u(n), ux(n), uy(n), found(n), found_x(n), found_y(n);
        influence.current->normal(p, u);
        influence.current->precondition(z, u, found);
        influence.current->tangential(p, p, ux, uy);
        influence.current->precondition_tangential(ux, uy, found_x, found_y);
        const auto error = [&](const Values& values) {
            double sum = 0;
            for (std::size_t i = 0; i < n; ++i) sum += (values[i] - p[i]) * (values[i] - p[i]);
            return std::sqrt(sum / 192);
        };
        return Errors{error(found), std::max(error(found_x), error(found_y))};
    };
    const Errors creeps = errors(problem), stands = errors(elastic);
    CHECK(creeps.normal < 2 * stands.normal);
    CHECK(creeps.tangential < 2 * stands.tangential);
}
