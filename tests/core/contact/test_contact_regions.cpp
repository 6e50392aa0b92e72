// Tests regions of a contact that partly interact by their pressures.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <string>

#include "contact/contact_cases.hpp"
#include "contactd/error.hpp"
#include "operators/region_operator.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const RegionLimits left{{-5, 0}, {-3, 3}}, right{{0, 5}, {-3, 3}};
const Extent everywhere{-100, 100};

/// Creates two balls of 100 mm, 2.4 mm apart, on a plane; their contacts nearly touch.
ContactProblem two_balls(const Material& upper = {82000, 0.28}) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(40, 24, 0.125, 0.125);
    problem.bodies = Bodies::of({upper, {82000, 0.28}});
    Values gap;
    for (int iy = 0; iy < problem.grid.ny; ++iy)
        for (int ix = 0; ix < problem.grid.nx; ++ix) {
            const double x = std::abs(problem.grid.x(ix)) - 1.2, y = problem.grid.y(iy);
            gap.push_back((x * x + y * y) / 200);
        }
    problem.gap = gap;
    problem.approach = 0.01;
    return problem;
}

ContactProblem with_share(ContactProblem problem, double share) {
    problem.regions = {{left, right}, {1, share, share, 1}};
    return problem;
}

ContactSolution converged(const ContactProblem& problem) {
    const ContactSolution solution = solve_half_spaces(problem);
    REQUIRE(solution.converged());
    return solution;
}

void check_close(const Values& a, const Values& b, double tolerance) {
    REQUIRE(a.size() == b.size());
    const double most = largest(b);
    for (std::size_t i = 0; i < a.size(); ++i) CHECK_THAT(a[i], WithinAbs(b[i], tolerance * most));
}

}  // namespace

TEST_CASE("Regions that share all of their displacements are one contact") {
    check_close(converged(with_share(two_balls(), 1)).pressure, converged(two_balls()).pressure, 1e-6);
}

TEST_CASE("Regions that share nothing are contacts of their own, each under the same approach") {
    ContactProblem alone = two_balls();
    alone.regions = {{left}, {1}};
    const ContactSolution one = converged(alone), both = converged(with_share(two_balls(), 0)),
                          plain = converged(two_balls());
    CHECK_THAT(both.forces.Fn, WithinRel(2 * one.forces.Fn, 1e-6));
    CHECK(both.forces.Fn > 1.1 * plain.forces.Fn);
    for (int iy = 0; iy < alone.grid.ny; ++iy)
        for (int ix = alone.grid.nx / 2; ix < alone.grid.nx; ++ix) {
            const auto at = static_cast<std::size_t>(iy) * 40 + static_cast<std::size_t>(ix);
            CHECK(one.pressure[at] == 0);
            CHECK_THAT(both.pressure[at], WithinAbs(both.pressure[at + 39 - 2 * static_cast<std::size_t>(ix)], 1e-2));
        }
}

TEST_CASE("The more regions share, the less force an approach takes") {
    double before = 1e9;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double force = converged(with_share(two_balls(), share)).forces.Fn;
        CHECK(force < before);
        before = force;
    }
}

TEST_CASE("Pressures of regions close the gap that their share of displacements leaves") {
    const ContactProblem problem = with_share(two_balls(), 0.3);
    const ContactSolution solution = converged(problem);
    const auto bodies = operators_of(problem, pair_table(problem)).current;
    const Values& gap = std::get<Values>(*problem.gap);
    const std::size_t n = gap.size();
    Values by_left(n, 0.0), by_right(n, 0.0), from_left(n), from_right(n);
    for (std::size_t i = 0; i < n; ++i) (i % 40 < 20 ? by_left : by_right)[i] = solution.pressure[i];
    bodies->normal(by_left, from_left);
    bodies->normal(by_right, from_right);
    for (std::size_t i = 0; i < n; ++i) {
        const bool is_left = i % 40 < 20;
        const double u = is_left ? from_left[i] + 0.3 * from_right[i] : from_right[i] + 0.3 * from_left[i];
        const double left_open = gap[i] - *problem.approach + u;
        if (solution.pressure[i] > 0)
            CHECK_THAT(left_open, WithinAbs(0, 1e-9));
        else
            CHECK(left_open > -1e-9);
    }
}

TEST_CASE("Elements of no region cannot touch, and an element belongs to the first region that holds it") {
    ContactProblem problem = two_balls();
    problem.regions = {{{{-1.5, -0.9}, everywhere}, {everywhere, {0.2, 0.6}}}, {1, 0, 0, 1}};
    const ContactSolution solution = converged(problem);
    CHECK(solution.elements.contact > 0);
    for (std::size_t i = 0; i < solution.pressure.size(); ++i) {
        const double x = problem.grid.x(static_cast<int>(i) % 40), y = problem.grid.y(static_cast<int>(i) / 40);
        if ((x < -1.5 || x > -0.9) && (y < 0.2 || y > 0.6)) CHECK(solution.pressure[i] == 0);
    }
}

TEST_CASE("Regions under a prescribed force carry it together, of dissimilar bodies, too, and with friction") {
    ContactProblem problem = with_share(two_balls({40000, 0.35}), 0.4);
    problem.approach.reset();
    problem.Fn = 900;
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = GENERATE(Motion(Shift{{0.001, 0}}), Motion(Rolling{.xi = 1e-3, .phi = 1e-4}));
    const ContactSolution solution = converged(problem);
    CHECK_THAT(solution.forces.Fn, WithinRel(900.0, 1e-9));
    CHECK(std::abs(solution.forces.Fx) > 10);
}

TEST_CASE("Derivatives of regions are those of differences of solves") {
    ContactProblem problem = with_share(two_balls(), 0.35);
    problem.derivatives = true;
    const ContactSolution middle = converged(problem);
    REQUIRE((middle.derivatives && middle.derivatives->Fn));
    problem.derivatives = false;
    const double step = 1e-6;
    problem.approach = 0.01 + step;
    const double above = converged(problem).forces.Fn;
    problem.approach = 0.01 - step;
    const double below_it = converged(problem).forces.Fn;
    CHECK_THAT(middle.derivatives->Fn->approach.value(), WithinRel((above - below_it) / (2 * step), 1e-3));
}

TEST_CASE("The operator of regions is symmetric, and the same on boxes") {
    const ContactProblem problem = two_balls();
    const auto bodies = operators_of(problem, pair_table(problem)).current;
    RegionShares regions{{}, {1, 0.2, 0.7, 0.2, 1, 0, 0.7, 0, 1}, 3};
    for (std::size_t i = 0; i < bodies->size(); ++i) regions.region.push_back(static_cast<int>(i % 7) % 4 - 1);
    const RegionOperator whole(bodies, regions);
    const Values p = random_values(whole.size(), 1), q = random_values(whole.size(), 2);
    Values up(p.size()), uq(p.size());
    whole.normal(p, up);
    whole.normal(q, uq);
    double pq = 0, qp = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        pq += p[i] * uq[i];
        qp += q[i] * up[i];
    }
    CHECK_THAT(pq, WithinRel(qp, 1e-10));
    REQUIRE(whole.boxes() != nullptr);
    const ElementBox box{3, 2, 20, 12};
    const auto part = whole.boxes()->influence(box);
    Values inside(p.size(), 0.0), cropped;
    for (int iy = 0; iy < box.ny; ++iy)
        for (int ix = 0; ix < box.nx; ++ix) {
            const auto at =
                static_cast<std::size_t>(box.first_y + iy) * 40 + static_cast<std::size_t>(box.first_x + ix);
            inside[at] = p[at];
            cropped.push_back(p[at]);
        }
    Values displacement(part->size());
    whole.normal(inside, up);
    part->normal(cropped, displacement);
    for (int iy = 0; iy < box.ny; ++iy)
        for (int ix = 0; ix < box.nx; ++ix)
            CHECK_THAT(
                displacement[static_cast<std::size_t>(iy * box.nx + ix)],
                WithinRel(
                    up[static_cast<std::size_t>(box.first_y + iy) * 40 + static_cast<std::size_t>(box.first_x + ix)],
                    1e-9));
}

TEST_CASE("Regions that cannot be are refused by their names") {
    const auto refusal = [](const ContactRegions& regions, Model model = Model::full) {
        ContactProblem problem = two_balls();
        problem.regions = regions;
        problem.model = model;
        if (model != Model::full) problem.gap = Paraboloid{100, 100};
        try {
            validate(problem);
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return std::string("nothing");
    };
    CHECK(refusal({{left, right}, {1, 0.5, 0.5, 1}}) == "nothing");
    CHECK(refusal({{}, {}}) == "regions.limits");
    CHECK(refusal({{left, {{1, 1}, {0, 1}}}, {1, 0, 0, 1}}) == "regions.limits[1].x");
    CHECK(refusal({{left, {{0, 1}, {0, std::nan("")}}}, {1, 0, 0, 1}}) == "regions.limits[1].y");
    CHECK(refusal({{left, right}, {1, 0.5, 1}}) == "regions.shares");
    CHECK(refusal({{left, right}, {1, 0.5, 0.4, 1}}) == "regions.shares[1]");
    CHECK(refusal({{left, right}, {0.9, 0.5, 0.5, 1}}) == "regions.shares[0]");
    CHECK(refusal({{left, right}, {1, 1.5, 1.5, 1}}) == "regions.shares[1]");
    CHECK(refusal({{left}, {1}}, Model::hertz) == "regions");
}
