// Tests longitudinally uniform bodies in contact, against half-spaces, and with strips that end at an edge of the body.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <string>

#include "contact_cases.hpp"
#include "contactd/rotated_strips.hpp"
#include "contactd/strip_frames.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

const Material steel{82000, 0.28}, rubber{5, 0.45};

Body uniform_body(const Material& material, const Section& section, IcSource source = IcSource::analytic) {
    Ics ics;
    ics.source = source;
    ics.body = BodyShape::longitudinally_uniform;
    if (source == IcSource::fem) ics.accuracy = 1e-2;
    ics.section = section;
    return {material, ics};
}

/// Uses strips that end at the edge of a block, whose table is that of half-spaces here.
ContactProblem ball_at_edge(IcSource source, bool mirrored = false) {
    ContactProblem problem;
    problem.grid = {12, 20, 0.25, 0.25, -1.5, -4.5};
    const Body block = uniform_body(steel, {EdgeBlock{100, 50, 0}}, source), rigid{Material::rigid()};
    problem.bodies = mirrored ? Bodies{block, rigid} : Bodies{rigid, block};
    problem.gap = Paraboloid{50, 50};
    problem.Fn = 3000;
    return problem;
}

ContactSolution solve(const ContactProblem& problem) {
    Grid longer = problem.grid;
    ++longer.nx;
    const auto table = [&](const Body& body) {
        if (const Section* section = body.section())
            return BodyTable(rotated_strips(*section, longer, body.material, LoadShape::constant));
        return BodyTable(StripTable());
    };
    Observer observer;
    return solve_contact(problem, make_influence(problem, table(problem.bodies.upper), table(problem.bodies.lower)),
                         observer);
}

bool says_cut_off(const ContactSolution& solution) {
    return std::ranges::any_of(solution.warnings, [](const std::string& warning) {
        return warning.find("which the solution neglects") != std::string::npos;
    });
}

}  // namespace

TEST_CASE("Closed forms are warned of where an edge or the ground of a block is near", "[uniform]") {
    const auto edge_warned = [](const ContactProblem& problem, const std::string& what) {
        return std::ranges::any_of(solve(problem).warnings, [&](const std::string& warning) {
            return warning.find(what) != std::string::npos && warning.find("ics.source fem") != std::string::npos;
        });
    };
    const std::string edge = "The edge of bodies.", ground = "neglect the support below the block";
    CHECK(edge_warned(ball_at_edge(IcSource::analytic), edge + "lower is 0 mm from the contact"));
    ContactProblem above = ball_at_edge(IcSource::analytic, true);
    CHECK(!edge_warned(above, edge));
    above.grid.y0 = -0.5;
    CHECK(edge_warned(above, edge + "upper is 0 mm from the contact"));
    CHECK(!edge_warned(ball_at_edge(IcSource::analytic), ground));
    CHECK(!edge_warned(ball_at_edge(IcSource::fem), edge));
    ContactProblem inside = ball_at_edge(IcSource::analytic);
    std::get<EdgeBlock>(std::get<Ics>(inside.bodies.lower.ics).section->shape) = {100, 1, 20};
    CHECK(!edge_warned(inside, edge));
    CHECK(edge_warned(inside, ground));
}

TEST_CASE("A contact that ends where the body does is not cut off by the grid", "[uniform]") {
    const ContactProblem problem = ball_at_edge(IcSource::fem);
    const ContactSolution solution = solve(problem);
    REQUIRE(solution.converged());
    REQUIRE(solution.pressure[static_cast<std::size_t>(problem.grid.nx * (problem.grid.ny - 1) + 6)] > 0);
    CHECK(solution.elements.border == 0);
    CHECK(!says_cut_off(solution));
    SECTION("but a half-space goes on behind its strips") {
        CHECK(says_cut_off(solve(ball_at_edge(IcSource::analytic))));
    }
    SECTION("and so does a block that begins before them") {
        ContactProblem inside = problem;
        inside.grid.y0 = -0.5;
        CHECK(says_cut_off(solve(inside)));
    }
    SECTION("the upper body's strips run the other way") {
        CHECK(says_cut_off(solve(ball_at_edge(IcSource::fem, true))));
        ContactProblem above = ball_at_edge(IcSource::fem, true);
        above.grid.y0 = -0.5;
        CHECK(!says_cut_off(solve(above)));
    }
}

TEST_CASE("A longitudinally uniform body and a half-space have the products of both together", "[uniform]") {
    const bool uniform_above = GENERATE(false, true);
    const double dq = GENERATE(0.4, 0.25);
    ContactProblem problem;
    problem.grid = Grid::of_elements(14, 10, 0.4, 0.4);
    const Section section = uniform_above ? Section{EdgeBlock{100, 50, 3}} : Section{RailSection{.from = 8}};
    problem.bodies =
        uniform_above ? Bodies{uniform_body(rubber, section), {steel}} : Bodies{{steel}, uniform_body(rubber, section)};
    if (!uniform_above) problem.columns = ContactColumns{.frames = strip_frames(section, 10, 0.4)};
    problem.friction = FrictionLaw{{0.3}};
    problem.motion = Rolling{.xi = 1e-3, .dq = dq};
    Grid longer = problem.grid;
    longer.nx += 2;
    const StripTable strips = rotated_strips(section, longer, rubber, LoadShape::constant);
    const IcTable flat = body_table(problem.grid, steel);
    const auto influence = [&](const ContactProblem& of, const BodyTable& upper, const BodyTable& lower) {
        return make_influence(of, upper, lower);
    };
    const ContactInfluence both = uniform_above ? influence(problem, BodyTable(strips), BodyTable(flat))
                                                : influence(problem, BodyTable(flat), BodyTable(strips));
    // Uses one body after the other, each on a rigid one.
    ContactProblem one = problem, other = problem;
    (uniform_above ? one.bodies.lower : one.bodies.upper) = Body{Material::rigid()};
    (uniform_above ? other.bodies.upper : other.bodies.lower) = Body{Material::rigid()};
    other.columns.reset();
    const BodyTable none{IcTable(problem.grid.nx, problem.grid.ny)};
    const ContactInfluence of_uniform = uniform_above ? influence(one, BodyTable(strips), BodyTable(StripTable()))
                                                      : influence(one, BodyTable(StripTable()), BodyTable(strips));
    const ContactInfluence of_flat =
        uniform_above ? influence(other, none, BodyTable(flat)) : influence(other, BodyTable(flat), none);

    const auto n = problem.grid.size();
    Values p(n), q(n), found_x(n), found_y(n), x(n), y(n);
    for (std::size_t i = 0; i < n; ++i) {
        p[i] = std::sin(1.0 + static_cast<double>(i));
        q[i] = std::cos(0.3 * static_cast<double>(i * i));
    }
    const double scale = strips(Axis::z, Axis::z, 0, 0, 0);
    const auto compare = [&](const auto& apply) {
        apply(both, found_x, found_y);
        Values sum_x(n, 0), sum_y(n, 0);
        for (const ContactInfluence* part : {&of_uniform, &of_flat}) {
            apply(*part, x, y);
            for (std::size_t i = 0; i < n; ++i) sum_x[i] += x[i], sum_y[i] += y[i];
        }
        for (std::size_t i = 0; i < n; ++i) {
            CHECK(std::abs(found_x[i] - sum_x[i]) < 1e-4 * scale);
            CHECK(std::abs(found_y[i] - sum_y[i]) < 1e-4 * scale);
        }
    };
    compare([&](const ContactInfluence& of, Values& ux, Values& uy) {
        of.current->normal(p, ux);
        of.current->normal(q, uy);
    });
    compare([&](const ContactInfluence& of, Values& ux, Values& uy) { of.current->tangential(p, q, ux, uy); });
    compare([&](const ContactInfluence& of, Values& ux, Values& uy) { of.current->tangential_of_normal(p, ux, uy); });
    compare([&](const ContactInfluence& of, Values& ux, Values& uy) { of.increment->tangential(p, q, ux, uy); });
    compare([&](const ContactInfluence& of, Values& ux, Values& uy) { of.increment->tangential_of_normal(p, ux, uy); });
}
