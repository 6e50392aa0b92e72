// What the library answers is what solve_contact answers, to the last bit.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include "client/cntc/calls.hpp"
#include "client/cntc/creep_table.hpp"
#include "contactd/closed_form_record.hpp"
#include "contactd/solve_contact.hpp"

using namespace contactd;
using namespace contactd::cntc::test;

namespace {

BodyTable table_of(const Grid& grid, const Body& body) {
    const IcSpec spec{*body.computed(), body.material, grid.dx, grid.dy, grid.nx, grid.ny};
    return body_table(closed_form_record(spec), spec);
}

/// As contact.solve of the daemon: its records are dimensionless.
ContactSolution solve(const ContactProblem& problem) {
    Observer observer;
    const auto& [upper, lower, pair] = problem.bodies;
    return solve_contact(problem, make_influence(problem, table_of(problem.grid, upper), table_of(problem.grid, lower)),
                         observer);
}

/// wheel() in core's words.
ContactProblem wheel_problem() {
    ContactProblem problem;
    problem.grid = Grid::of_elements(25, 25, 2 * 6 * 1.1 / 25, 2 * 4 * 1.1 / 25);
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}});
    problem.gap = SemiAxes{6, 4};
    problem.Fn = 50000;
    problem.friction = FrictionLaw{{0.3}};
    Rolling rolling;
    rolling.xi = 0.002;
    rolling.eta = 0.001;
    rolling.phi = 1e-4;
    rolling.dq = problem.grid.dx;
    rolling.spin_offset = 1.0 / 6;
    problem.motion = rolling;
    return problem;
}

Rolling& rolling_of(ContactProblem& problem) {
    return std::get<Rolling>(problem.motion);
}

void check_same(Case& contact, const ContactProblem& problem) {
    const ContactSolution expected = solve(problem);
    REQUIRE(expected.converged());

    REQUIRE(contact.calculate() == expected.elements.border);

    CHECK(contact.forces() ==
          ContactForces{expected.forces.Fn, expected.forces.Fx, expected.forces.Fy, expected.forces.Mz});
    CHECK(contact.max_pressure() == expected.pmax);
    CHECK(contact.found_penetration() == expected.approach);
    CHECK(contact.areas().contact == expected.area.contact);
    const bool rubs = problem.friction.has_value();
    CHECK(contact.areas().adhesion == (rubs ? expected.area.adhesion : expected.area.contact));
    CHECK(contact.areas().slip == (rubs ? expected.area.slip : 0));
    const Tractions tractions = contact.tractions();
    CHECK(tractions.pn == expected.pressure);
    CHECK(tractions.px == expected.traction_x);
    CHECK(tractions.py == expected.traction_y);
    std::vector<int> division;
    for (const ElementState state : expected.element_division)
        division.push_back(static_cast<int>(rubs ? state : std::min(state, ElementState::adhesion)));
    CHECK(contact.division() == division);
    if (rubs) {
        CHECK(contact.field(15) == expected.slip_x);
        CHECK(contact.field(16) == expected.slip_y);
    }
}

}  // namespace

TEST_CASE("steady rolling is that of solve_contact") {
    Case contact = wheel(1);
    check_same(contact, wheel_problem());
}

TEST_CASE("a direction of rolling is that of solve_contact, its step still an element along x") {
    Case contact = wheel(1);
    contact.rolling_step(0.5, 123);
    ContactProblem problem = wheel_problem();
    rolling_of(problem).chi = 0.5;
    check_same(contact, problem);
}

TEST_CASE("frictionless contact is that of solve_contact, its elements adhere") {
    Case contact = wheel(1);
    contact.flag(1972, 0);
    ContactProblem problem = wheel_problem();
    problem.friction.reset();
    check_same(contact, problem);
}

TEST_CASE("a penetration given is that of solve_contact") {
    Case contact = wheel(1);
    contact.penetration(0.06);
    ContactProblem problem = wheel_problem();
    problem.Fn.reset();
    problem.approach = 0.06;
    check_same(contact, problem);
}

TEST_CASE("a shift is that of solve_contact") {
    Case contact = wheel(1);
    contact.flag(1972, 1);
    contact.creepages(0.01, -0.004, 1e-3);
    ContactProblem problem = wheel_problem();
    Shift shift;
    shift.rigid_shift = {0.01, -0.004};
    shift.rotation = 1e-3;
    problem.motion = shift;
    check_same(contact, problem);
}

TEST_CASE("forces given are those of solve_contact, relative to the friction's bound") {
    Case contact = wheel(1);
    contact.flag(1974, 2);
    contact.creepages(0, 0, 1e-4);
    contact.tangential_forces(-0.5, 0.3);
    ContactProblem problem = wheel_problem();
    Rolling& rolling = rolling_of(problem);
    rolling.xi = rolling.eta = 0;
    rolling.force = {-0.5 * (0.3 * 50000), 0.3 * (0.3 * 50000)};
    check_same(contact, problem);
}

TEST_CASE("one force given keeps the lateral creepage") {
    Case contact = wheel(1);
    contact.flag(1974, 1);
    contact.tangential_forces(-0.5, 777);
    ContactProblem problem = wheel_problem();
    rolling_of(problem).force.Fx = -0.5 * (0.3 * 50000);
    check_same(contact, problem);
    CHECK(contact.found_creepages().vy == 0.001);
}

TEST_CASE("bilinear coefficients are those of solve_contact") {
    Case contact = wheel(1);
    contact.flag(1978, 3);
    ContactProblem problem = wheel_problem();
    Ics ics;
    ics.load_shape = LoadShape::bilinear;
    problem.bodies = Bodies::of({{82000, 0.28}, {82000, 0.28}}, ics);
    check_same(contact, problem);
}

TEST_CASE("bodies that differ are those of solve_contact, body 1 the upper one") {
    Case contact = wheel(1);
    contact.material(0.28, 0.1, 82000, 41000);
    ContactProblem problem = wheel_problem();
    problem.bodies = Bodies::of({{82000, 0.28}, {41000, 0.1}});
    check_same(contact, problem);
}

TEST_CASE("friction that falls with the slip is that of solve_contact") {
    const int law = GENERATE(2, 4);
    Case contact = wheel(1);
    contact.velocity(10000);
    contact.friction(law, {0.2, 0.1, 50, 0, 1, 0, 1});
    ContactProblem problem = wheel_problem();
    rolling_of(problem).velocity = 10000;
    problem.friction = FrictionLaw{{0.2 + 0.1},
                                   KineticFriction{law == 2 ? SlipLaw::linear : SlipLaw::exponential, 0.2,
                                                   law == 2 ? 100.0 : 50 / std::numbers::ln2}};
    check_same(contact, problem);
}

TEST_CASE("a rigid slip of the elements is that of solve_contact") {
    Case contact = wheel(1);
    Values wx, wy;
    for (int i = 0; i < 625; ++i) {
        wx.push_back(1e-4 * std::sin(i));
        wy.push_back(1e-4 * std::cos(2 * i));
    }
    contact.extra_slip(wx, wy);
    ContactProblem problem = wheel_problem();
    problem.rigid_slip = {wx, wy};
    check_same(contact, problem);
}

TEST_CASE("a distance of the elements is that of solve_contact, x fastest") {
    Case contact = wheel(1);
    ContactProblem problem = wheel_problem();
    problem.grid = {30, 20, 0.5, 0.6, -7, -6.5};
    contact.potential(1, {30, 20, -7, -6.5, 0.5, 0.6});
    Values h;
    for (int iy = 0; iy < 20; ++iy)
        for (int ix = 0; ix < 30; ++ix) {
            const double x = problem.grid.x(ix), y = problem.grid.y(iy);
            h.push_back(x * x / 900 + y * y / 600 + 1e-3 * std::cos(x + 2 * y));
        }
    contact.distance(9, h);
    problem.gap = h;
    rolling_of(problem).dq = 0.5;
    check_same(contact, problem);
}

TEST_CASE("every line of the table of creepages is that of solve_contact") {
    CreepTable table(1);
    std::size_t lines = 0;
    CreepTable::for_each([&](const CreepCase& k) {
        ++lines;
        const CreepLine line = table.solve(k);
        CAPTURE(k.ellipse, k.spin, k.direction, k.size);
        REQUIRE(line.error == 0);
        const Values hertz = table.contact().hertz_back();
        const auto [dx, dy] = table.contact().element_size();
        const Creepages creepages = CreepTable::creepages(k);
        ContactProblem problem = wheel_problem();
        problem.grid = Grid::of_elements(CreepTable::elements, CreepTable::elements, dx, dy);
        problem.bodies = Bodies::of({{1, CreepTable::nu}, {1, CreepTable::nu}});
        problem.gap = Paraboloid{1 / (2 * hertz[0]), 1 / (2 * hertz[1])};
        problem.Fn = 1;
        Rolling& rolling = rolling_of(problem);
        rolling.xi = creepages.vx;
        rolling.eta = creepages.vy;
        rolling.phi = creepages.phi;
        rolling.dq = dx;
        const Forces expected = solve(problem).forces;
        const ContactForces found = table.contact().forces();
        REQUIRE(found == ContactForces{expected.Fn, expected.Fx, expected.Fy, expected.Mz});
    });
    CHECK(lines == 3220);
}

TEST_CASE("operators that are kept from other cases change no bit") {
    Case kept = wheel(1);
    kept.rolling_step(0, 0.7);
    int fresh_ones = 1;
    for (const int tangential : {3, 0, 3, 1, 2, 0, 2, 3, 1, 0})
        for (const double nu : {0.28, 0.2}) {
            CAPTURE(tangential, nu);
            Case fresh = wheel(++fresh_ones);
            fresh.rolling_step(0, 0.7);
            for (Case* contact : {&kept, &fresh}) {
                contact->flag(1972, tangential);
                contact->material(nu, nu, 82000, 82000);
                if (tangential == 1) contact->creepages(0.01, 0, 0);
                if (tangential > 1) contact->creepages(0.002, 0.001, 1e-4);
                REQUIRE(contact->calculate() == 0);
            }
            CHECK(kept.forces() == fresh.forces());
            CHECK(kept.tractions().px == fresh.tractions().px);
        }
}
