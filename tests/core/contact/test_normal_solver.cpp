// Tests normal contact for one gap after another.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <memory>
#include <numeric>

#include "closed_forms/hertz.hpp"
#include "contact/normal/normal_solver.hpp"
#include "contactd/error.hpp"
#include "plain_operator.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const SolverSettings exact{1e-10, 200};

// Creates a sphere on a grid that is wider than its contact, so that boxes save products.
struct Sphere {
    Grid grid = Grid::of_elements(48, 40, 0.1, 0.1);
    PairOperator influence{half_space_pair(grid, {82000, 0.28}), grid.nx, grid.ny};
    Values distance = sampled(Paraboloid{300, 300}, grid);

    // Returns the distance less the approach, with a wave of this height, as caused by tractions of the other body.
    Values gap(double approach, double wave = 0) const {
        Values gap = distance;
        for (int iy = 0; iy < grid.ny; ++iy)
            for (int ix = 0; ix < grid.nx; ++ix) gap[at(grid, ix, iy)] += wave * std::sin(2 * grid.x(ix)) - approach;
        return gap;
    }
};

void check_same(const NormalSolution& solution, const NormalSolution& expected) {
    REQUIRE(solution.evidence.converged);
    REQUIRE(expected.evidence.converged);
    const double largest = *std::max_element(expected.pressure.begin(), expected.pressure.end());
    for (std::size_t i = 0; i < expected.pressure.size(); ++i)
        CHECK_THAT(solution.pressure[i], WithinAbs(expected.pressure[i], 1e-6 * largest));
    CHECK_THAT(solution.approach, WithinAbs(expected.approach, 1e-8));
    const auto sum = [](const Values& p) { return std::accumulate(p.begin(), p.end(), 0.0); };
    CHECK_THAT(sum(solution.pressure), WithinRel(sum(expected.pressure), 1e-8));
}

}  // namespace

TEST_CASE("a gap near the last one is solved from its solution, with fewer products", "[normal]") {
    const Sphere sphere;
    const auto plain = std::make_shared<PlainOperator>(
        std::make_shared<PairOperator>(half_space_pair(sphere.grid, {82000, 0.28}), 48, 40));
    const bool by_force = GENERATE(true, false);
    Observer observer;
    NormalSolver solver(*plain);
    const auto task = [&](const Values& gap) {
        return NormalTask{gap, by_force ? std::optional(3000 / sphere.grid.element_area()) : std::nullopt, exact};
    };
    Values gap = sphere.gap(0.01);
    NormalSolution last = solver.solve(task(gap), {}, {}, observer);
    for (const double wave : {1e-4, 1e-4, 1e-4, 1.1e-4, 1.11e-4}) {  // repeating it causes changes by rounding only
        gap = sphere.gap(0.01, wave);
        int before = plain->products();
        const NormalSolution again = solver.solve_again(task(gap), last.pressure, observer);
        const int kept = plain->products() - before;
        before = plain->products();
        const NormalSolution fresh = NormalSolver(*plain).solve(task(gap), last.pressure, {}, observer);
        CHECK(kept < plain->products() - before);
        check_same(again, fresh);
        last = again;
    }
}

TEST_CASE("a gap far from the last one is solved, too", "[normal]") {
    const Sphere sphere;
    Observer observer;
    NormalSolver solver(sphere.influence);
    const Values shallow = sphere.gap(1e-3), deep = sphere.gap(0.012), open = sphere.gap(-1e-3);
    NormalSolution last = solver.solve({shallow, {}, exact}, {}, {}, observer);
    for (const Values* gap : {&deep, &shallow, &open, &deep}) {  // one case beyond the first box, one without contact
        const NormalSolution again = solver.solve_again({*gap, {}, exact}, last.pressure, observer);
        check_same(again, NormalSolver(sphere.influence).solve({*gap, {}, exact}, {}, {}, observer));
        last = again;
    }
}

TEST_CASE("what overlaps beyond the box of a solve that is to be refined is found by the next", "[normal]") {
    const Sphere sphere;
    Observer observer;
    NormalSolver solver(sphere.influence);
    const Values shallow = sphere.gap(1e-3), deep = sphere.gap(0.012);
    const NormalSolution last = solver.solve({shallow, {}, exact}, {}, {}, observer);
    const NormalSolution within = solver.solve_again({deep, {}, exact, true}, last.pressure, observer);
    const NormalSolution expected = NormalSolver(sphere.influence).solve({deep, {}, exact}, {}, {}, observer);
    const auto in_contact = [](const NormalSolution& solution) {
        return std::count_if(solution.pressure.begin(), solution.pressure.end(), [](double p) { return p > 0; });
    };
    CHECK(in_contact(within) < in_contact(expected));
    check_same(solver.solve_again({deep, {}, exact}, within.pressure, observer), expected);
}

TEST_CASE("another force is met from the last solution", "[normal]") {
    const Sphere sphere;
    Observer observer;
    NormalSolver solver(sphere.influence);
    const auto task = [&](double Fn) { return NormalTask{sphere.distance, Fn / sphere.grid.element_area(), exact}; };
    NormalSolution last = solver.solve(task(3000), {}, {}, observer);
    for (const double Fn : {3100.0, 3200.0, 500.0, 0.0, 3000.0}) {
        const NormalSolution again = solver.solve_again(task(Fn), last.pressure, observer);
        check_same(again, NormalSolver(sphere.influence).solve(task(Fn), {}, {}, observer));
        last = again;
    }
}

TEST_CASE("what did not converge is not gone on from", "[normal]") {
    const Sphere sphere;
    const Values gap = sphere.gap(0.01), next = sphere.gap(0.0101);
    Observer observer;
    NormalSolver solver(sphere.influence);
    const NormalSolution failed = solver.solve({gap, {}, {1e-12, 1}}, {}, {}, observer);
    REQUIRE_FALSE(failed.evidence.converged);
    check_same(solver.solve_again({next, {}, exact}, failed.pressure, observer),
               NormalSolver(sphere.influence).solve({next, {}, exact}, {}, {}, observer));
}
