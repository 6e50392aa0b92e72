#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "contact/contact_cases.hpp"
#include "contactd/error.hpp"
#include "wheel_rail/patches/half_space_cache.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinRel;

namespace {

ContactProblem problem_on(const Grid& grid) {
    ContactProblem problem;
    problem.grid = grid;
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    return problem;
}

}  // namespace

TEST_CASE("Operators of grids that differ by their origin only are the same ones") {
    HalfSpaceCache cache(problem_on({}).bodies);
    const ContactProblem here = problem_on({12, 9, 0.2, 0.3, -1.2, -1.5}), there = problem_on({12, 9, 0.2, 0.3, 5, 7});
    const ContactProblem wider = problem_on({13, 9, 0.2, 0.3, -1.2, -1.5});
    const ContactInfluence first = cache.of(here);
    CHECK(cache.of(there).current == first.current);
    CHECK(cache.of(wider).current != first.current);
    CHECK(cache.of(here).current == first.current);
}

TEST_CASE("Cached operators are those that are made alone") {
    HalfSpaceCache cache(problem_on({}).bodies);
    cache.of(problem_on(Grid::of_elements(30, 20, 0.2, 0.3)));  // its table is larger
    const ContactProblem problem = problem_on(Grid::of_elements(8, 7, 0.2, 0.3));
    const Values pressure = random_values(problem.grid.size(), 3, 0, 1);
    Values kept(pressure.size()), alone(pressure.size());
    cache.of(problem).current->normal(pressure, kept);
    make_influence(problem, pair_table(problem)).current->normal(pressure, alone);
    for (std::size_t i = 0; i < kept.size(); ++i) CHECK_THAT(kept[i], WithinRel(alone[i], 1e-10));
}

TEST_CASE("Bodies that are no half-spaces in closed form need a source, and a source is asked") {
    WheelRailSetup setup = cylinder_on_arc(300);
    setup.dx = setup.dy = 1;
    std::get<Ics>(setup.bodies.upper.ics).source = IcSource::fem;
    CHECK_THROWS_WITH(WheelRailContact(setup), ContainsSubstring("bodies are not half-spaces"));

    setup = cylinder_on_arc(300);
    setup.dx = setup.dy = 1;
    int asked = 0;
    const WheelRailContact contact(setup, [&](const ContactProblem& problem, const PatchStrips&, Observer&) {
        ++asked;
        return make_influence(problem, pair_table(problem));
    });
    WheelRailState state;
    state.Fz = 60000;
    Observer observer;
    const WheelRailSolution solution = contact.solve(state, observer);
    CHECK(asked == solution.force->iterations);
    CHECK_THAT(solution.z, WithinRel(solve(setup, state).z, 1e-9));
}
