// Tests coefficients of contacts between wheel and rail that consider their curvature.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

#include "contact/contact_cases.hpp"
#include "contactd/error.hpp"
#include "contactd/patch_influence.hpp"
#include "contactd/rotated_strips.hpp"
#include "contactd/solve_contact.hpp"
#include "contactd/strip_frames.hpp"
#include "wheel_rail/patches/half_space_cache.hpp"
#include "wheel_rail/patches/section_strips.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double of_rail = 13, of_wheel = 13.3;

WheelRailSetup throat_on_rail(Conformal conformal) {
    WheelRailSetup setup = cylinder_on_arc(of_rail);
    setup.rail.shape = ArcProfile{of_rail, 0, -10, 10};
    setup.wheel.shape = ArcProfile{of_wheel, 0, -10, 10};
    setup.dx = setup.dy = 0.4;
    setup.conformal = conformal;
    return setup;
}

/// Uses S1002 in the gauge corner of 60E1, where radii change along both.
WheelRailSetup in_the_corner(Conformal conformal) {
    WheelRailSetup setup;
    setup.dx = setup.dy = 0.4;
    setup.conformal = conformal;
    return setup;
}

WheelRailState loaded(double y, double Fz) {
    WheelRailState state;
    state.position.y = y;
    state.Fz = Fz;
    return state;
}

/// Stores the last requested patch, with its strips.
struct Asked {
    ContactProblem problem;
    PatchStrips strips;
};

Asked asked_by(const WheelRailSetup& setup, const WheelRailState& state) {
    Asked last;
    const WheelRailContact contact(setup, [&](const ContactProblem& problem, const PatchStrips& strips, Observer&) {
        last = {problem, strips};
        return make_influence(problem, pair_table(problem));
    });
    Observer observer;
    contact.solve(state, observer);
    return last;
}

/// Returns the largest difference between displacements of both operators under random loads, over the largest one.
double difference(const ContactInfluence& a, const ContactInfluence& b, std::size_t size) {
    const Values px = random_values(size, 1, -1, 1), py = random_values(size, 2, -1, 1),
                 pz = random_values(size, 3, 0, 1);
    const auto displacements = [&](const ContactInfluence& influence) {
        Values x(size), y(size), z(size), all;
        influence.current->normal(pz, z);
        all = z;
        influence.current->tangential(px, py, x, y);
        all.insert(all.end(), x.begin(), x.end());
        all.insert(all.end(), y.begin(), y.end());
        return all;
    };
    const Values first = displacements(a), second = displacements(b);
    double largest = 0, off = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        largest = std::max(largest, std::abs(first[i]));
        off = std::max(off, std::abs(first[i] - second[i]));
    }
    return off / largest;
}

}  // namespace

TEST_CASE("On flat rows rotated half-spaces are half-spaces") {
    ContactProblem problem;
    problem.grid = {12, 9, 0.2, 0.3, -1.2, -1.5};
    problem.bodies = Bodies::of({{82000, 0.28}, {60000, 0.35}});
    HalfSpaceCache cache(problem.bodies);
    PatchStrips inclined;
    for (int i = 0; i < problem.grid.ny; ++i) inclined.frames.push_back({0.3 * i, 0, 0.4});
    CHECK(difference(cache.of(problem, inclined), cache.of(problem), problem.grid.size()) < 1e-10);
    inclined.frames.back().angle += 0.1;
    CHECK(difference(cache.of(problem, inclined), cache.of(problem), problem.grid.size()) > 1e-3);
}

// Coefficients of Blanco-Lorenzo reduce pmax by one to three per cent compared with flat rows.
TEST_CASE("In a conformal contact rotated half-spaces bear the force with a lower pressure") {
    const WheelRailSolution flat = solve(throat_on_rail(Conformal::half_space), loaded(0, 60000));
    const WheelRailSolution rotated = solve(throat_on_rail(Conformal::rotated), loaded(0, 60000));
    REQUIRE(rotated.converged());
    CHECK_THAT(rotated.forces.track.Fz, WithinRel(60000, 1e-6));
    CHECK_THAT(rotated.forces.track.Fy, WithinAbs(0, 1e-3));
    const double ratio = rotated.patches.at(0).solution.pmax / flat.patches.at(0).solution.pmax;
    CHECK(ratio < 0.995);
    CHECK(ratio > 0.96);
    const auto& pressure = rotated.patches[0].solution.pressure;
    const Grid& grid = rotated.patches[0].place.grid;
    const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
    for (std::size_t i = 0; i < pressure.size(); ++i)  // mirrored across the track
        CHECK_THAT(pressure[i],
                   WithinAbs(pressure[(ny - 1 - i / nx) * nx + i % nx], 1e-5 * flat.patches[0].solution.pmax));
}

TEST_CASE("Of half-spaces of which only displacements turn a throat is as stiff as of those that turn by halves") {
    const WheelRailSolution flat = solve(throat_on_rail(Conformal::half_space), loaded(0, 60000));
    const WheelRailSolution rotated = solve(throat_on_rail(Conformal::rotated), loaded(0, 60000));
    const WheelRailSolution displaced = solve(throat_on_rail(Conformal::rotated_displacements), loaded(0, 60000));
    // To second order of the angles both are the same along the normal.
    const double pmax = displaced.patches.at(0).solution.pmax;
    CHECK_THAT(pmax, WithinRel(rotated.patches.at(0).solution.pmax, 0.02));
    CHECK(pmax < flat.patches.at(0).solution.pmax);
}

TEST_CASE("Where surfaces are nearly flat rotated and flat half-spaces agree") {
    const WheelRailSolution flat = solve(in_the_corner(Conformal::half_space), loaded(0, 60000));
    const WheelRailSolution rotated = solve(in_the_corner(Conformal::rotated), loaded(0, 60000));
    CHECK_THAT(rotated.patches.at(0).solution.pmax, WithinRel(flat.patches.at(0).solution.pmax, 2e-3));
    CHECK_THAT(rotated.z, WithinRel(flat.z, 1e-3));
}

TEST_CASE("A left wheel on rotated half-spaces is a right one in a mirror") {
    WheelRailSetup setup = in_the_corner(Conformal::rotated);
    WheelRailState state = loaded(6, 60000);
    state.position.yaw = 0.01;
    state.velocity = {20000, 0, 0, 0, 0, -20000 / 460.0};
    const WheelRailSolution right = solve(setup, state);
    REQUIRE(right.converged());
    setup.side = Side::left;
    state.position = {-6, 0, 0, -0.01};
    const WheelRailSolution left = solve(setup, state);
    CHECK(left.forces.track.Fx == right.forces.track.Fx);
    CHECK(left.forces.track.Fy == -right.forces.track.Fy);
    CHECK(left.forces.track.Fz == right.forces.track.Fz);
}

TEST_CASE("Automatic contacts are rotated where they bend, and planes where they do not") {
    const WheelRailSetup automatic = throat_on_rail(Conformal::automatic);
    const WheelRailSolution bent = solve(automatic, loaded(0, 60000));
    CHECK(bent.patches.at(0).solution.pmax ==
          solve(throat_on_rail(Conformal::rotated), loaded(0, 60000)).patches.at(0).solution.pmax);
    CHECK(!bent.patches[0].place.rows.empty());
    const WheelRailSolution plane = solve(in_the_corner(Conformal::automatic), loaded(0, 60000));
    CHECK(plane.patches.at(0).place.rows.empty());
    CHECK(plane.z == solve(in_the_corner(Conformal::off), loaded(0, 60000)).z);
    Observer observer;
    const WheelRailGeometry geometry = WheelRailContact(automatic).locate(loaded(0, 60000));
    CHECK(geometry.places.at(0).rows.size() == bent.patches[0].place.rows.size());
    CHECK(geometry.warnings.empty());
}

TEST_CASE("A planar contact that bends too much says what would follow it") {
    const WheelRailSolution plane = solve(throat_on_rail(Conformal::off), loaded(0, 60000));
    REQUIRE(!plane.warnings.empty());
    CHECK_THAT(plane.warnings[0],
               ContainsSubstring("too strongly curved") && ContainsSubstring("Set conformal to rotated"));
}

// The rows of a wheel's contact are the strips of any contact, except for the direction of the approach.
TEST_CASE("Rows of a wheel's contact are strips, on which contact is the same") {
    const WheelRailSolution wheel = solve(throat_on_rail(Conformal::half_space), loaded(0, 60000));
    const WheelRailPatch& patch = wheel.patches.at(0);
    ContactProblem problem;
    problem.grid = patch.place.grid;
    problem.bodies = throat_on_rail(Conformal::off).bodies;
    problem.columns = strips_of(patch.place);
    REQUIRE(problem.columns->frames.size() == static_cast<std::size_t>(problem.grid.ny));
    const double approach = patch.place.approach + 1;
    Values gap;
    for (std::size_t i = 0; i < patch.gap.size(); ++i) {
        const double cosine = std::cos(problem.columns->frames[i / problem.grid.nx].angle - problem.columns->direction);
        gap.push_back(patch.gap[i] - patch.place.approach + approach * cosine);
    }
    problem.gap = gap;
    problem.approach = approach;
    Observer observer;
    const ContactSolution solution = solve_contact(problem, make_influence(problem, pair_table(problem)), observer);
    CHECK_THAT(solution.pmax, WithinRel(patch.solution.pmax, 1e-3));
    REQUIRE(solution.resultant);
    CHECK_THAT(-solution.resultant->Fz, WithinRel(-wheel.forces.track.Fz, 1e-3));
}

TEST_CASE("Strips of sections rotate as the rows do that lie on them") {
    const double y = GENERATE(0.0, 5.5, 6.5, 0.5);
    const bool throat = y == 0.5;  // for profiles without a section
    const Asked asked =
        asked_by(throat ? throat_on_rail(Conformal::fem) : in_the_corner(Conformal::fem), loaded(y, 60000));
    CHECK(std::holds_alternative<OutlineSection>(asked.strips.rail->spec.section->shape) == throat);
    REQUIRE(asked.strips.rail);
    REQUIRE(asked.strips.wheel);
    const auto& rows = asked.strips.frames;
    const auto frames_of = [](const BodyStrips& body) {
        return strip_frames(*body.spec.section, body.spec.ny, body.spec.dy);
    };
    const auto rail = frames_of(*asked.strips.rail), wheel = frames_of(*asked.strips.wheel);
    const std::size_t count = rows.size(), middle = count / 2;
    const auto on_rail = [&](std::size_t i) { return rail.at(static_cast<std::size_t>(asked.strips.rail->first) + i); };
    const auto on_wheel = [&](std::size_t i) {
        return wheel.at(static_cast<std::size_t>(asked.strips.wheel->first) + count - 1 - i);
    };
    for (std::size_t i = 0; i < count; ++i) {
        INFO("row " << i << " of " << count << " at y = " << y);
        // Uses the mean of both; each deviates by at most half a strip, which R13 rotates by 0.015.
        const double of_rail_angle = on_rail(i).angle - on_rail(middle).angle;
        const double of_wheel_angle = on_wheel(i).angle - on_wheel(middle).angle;
        CHECK_THAT(-(rows[i].angle - rows[middle].angle), WithinAbs(0.5 * (of_rail_angle + of_wheel_angle), 0.035));
    }
}

TEST_CASE("Tables of sections begin and end at multiples of many strips, wherever a wheel stands") {
    const auto blocks = [](double strips) { return strips / 32; };
    for (const double y : {-1.0, 0.0, 0.3, 2.1}) {
        INFO("y = " << y);
        const Asked asked = asked_by(in_the_corner(Conformal::fem), loaded(y, 60000));
        const IcSpec &rail = asked.strips.rail->spec, &wheel = asked.strips.wheel->spec;
        const double on_rail = std::get<RailSection>(rail.section->shape).from / rail.dy + 0.5;
        const double on_wheel = std::get<WheelRimSection>(wheel.section->shape).from / wheel.dy - 0.5;
        for (const double strips : {on_rail, on_wheel, on_rail + rail.ny, on_wheel + wheel.ny})
            CHECK_THAT(blocks(strips), WithinAbs(std::round(blocks(strips)), 1e-9));
        const int rows = asked.problem.grid.ny;
        CHECK(asked.strips.rail->first >= 2);
        CHECK(asked.strips.rail->first + rows + 2 <= rail.ny);
        CHECK(asked.strips.wheel->first >= 2);
        CHECK(asked.strips.wheel->first + rows + 2 <= wheel.ny);
    }
}

TEST_CASE("Tables of sections that know nothing but the rotation of surfaces are rotated half-spaces") {
    const WheelRailState state = loaded(5.5, 60000);
    const Asked asked = asked_by(in_the_corner(Conformal::fem), state);
    const auto record_of = [&](const BodyStrips& body) {
        IcSpec unit = body.spec;
        unit.source = IcSource::analytic;
        Grid grid = asked.problem.grid;
        grid.ny = unit.ny;
        IcRecord record{unit, rotated_strips(*unit.section, grid, unit.material, LoadShape::constant), {}};
        StripTable& table = std::get<StripTable>(record.tables);
        for (double& value : table.values) value *= unit.material.G / unit.dx;
        return record;
    };
    const IcRecord rail = record_of(*asked.strips.rail), wheel = record_of(*asked.strips.wheel);
    const ContactInfluence sections = patch_influence(asked.problem, asked.strips, &rail, &wheel);
    PatchStrips rows = asked.strips;
    rows.rail.reset();
    rows.wheel.reset();
    const ContactInfluence rotated = patch_influence(asked.problem, rows);
    CHECK(difference(sections, rotated, asked.problem.grid.size()) < 5e-3);
    // The opposite order, or wrong strips, would be detected.
    std::reverse(rows.frames.begin(), rows.frames.end());
    CHECK(difference(sections, patch_influence(asked.problem, rows), asked.problem.grid.size()) > 1e-2);
}

TEST_CASE("What sections can not do is refused") {
    Observer observer;
    WheelRailSetup setup = in_the_corner(Conformal::fem);
    CHECK_THROWS_WITH(solve(setup, loaded(0, 60000)), ContainsSubstring("conformal is fem, whose tables"));
    setup.track.rail_origin = ProfilePoint{750, 0};
    setup.rail_slices = {{0, setup.rail}, {1000, setup.rail}};
    CHECK_THROWS_WITH(validate(setup), ContainsSubstring("conformal is fem, but the rail has slices"));
    setup = throat_on_rail(Conformal::fem);
    setup.rail.shape = ArcProfile{of_rail, 0, -2.856, 2.856};  // half a strip less than its rows require, on both sides
    CHECK_THROWS_WITH(asked_by(setup, loaded(0, 60000)),
                      ContainsSubstring("reaches the end of the profile of the rail"));
}
