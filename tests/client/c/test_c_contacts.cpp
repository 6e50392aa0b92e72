// The C interface solves what the C++ client solves, to the last bit: through a daemon.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

#include "c_contact.hpp"
#include "client/cpp/own_daemon.hpp"
#include "contactd/client/session.hpp"

using Catch::Approx;

namespace {

contactd::SessionSpec sphere() {
    contactd::SessionSpec spec;
    spec.setup.grid = contactd::Grid::centred(across, across, 0.2, 0.2);
    spec.setup.bodies = {{200, 0.42}, {200, 0.42}};
    spec.load.gap = contactd::Paraboloid{50, 50};
    spec.load.approach = 0.02;
    return spec;
}

Read read(const contactd::ContactSolution& solution) {
    const contactd::Forces& forces = solution.forces;
    return {forces.Fn, forces.Fx, forces.Fy, forces.Mz, solution.approach, solution.pmax};
}

/// A daemon, what speaks C++ with it and what speaks C.
struct Both {
    Daemon daemon;
    contactd::client::Client client{daemon.endpoint(), {.connect_timeout = std::chrono::seconds(20)}};
    Place place{daemon.endpoint()};
};

}  // namespace

TEST_CASE("A contact in C shifts as one in C++ does, array by array", "[c]") {
    Both both;
    contactd::SessionSpec spec = sphere();
    spec.setup.friction = contactd::FrictionLaw{{0.4}};
    contactd::Shift shift;
    shift.rigid_shift.x = 0.004;
    spec.load.motion = shift;
    contactd::client::Session session(both.client, spec);
    const Handle contact(both.place);
    set_sphere(contact);
    REQUIRE(contactd_set_mu(contact, 0.4) == CONTACTD_OK);
    REQUIRE(contactd_set_shift(contact, 0.004, 0, 0) == CONTACTD_OK);
    for (const char* array : every_array) REQUIRE(contactd_want(contact, array, 1) == CONTACTD_OK);
    require_ok(contactd_start(contact), contact);

    contactd::StepInput input;
    input.fields = contactd::all_solution_fields;
    for (const double x : {0.004, -0.007}) {
        shift.rigid_shift.x = x;
        input.motion = shift;
        const contactd::ContactSolution solution = session.step(input).solution;
        REQUIRE(contactd_set_shift(contact, x, 0, 0) == CONTACTD_OK);

        CHECK(stepped(contact) == read(solution));
        CHECK(get_array(contact, "pressure") == solution.pressure);
        CHECK(get_array(contact, "traction_x") == solution.traction_x);
        CHECK(get_array(contact, "traction_y") == solution.traction_y);
        CHECK(get_array(contact, "slip_x") == solution.slip_x);
        CHECK(get_array(contact, "slip_y") == solution.slip_y);
        CHECK(std::ranges::equal(get_array(contact, "element_division"), solution.element_division,
                                 [](double a, contactd::ElementState b) { return a == static_cast<int>(b); }));
        std::int32_t all = 0, adhesion = 0, slip = 0, border = 0, number = 0, ran = 0, converged = 0, warnings = 0;
        double area = 0, adhesion_area = 0, slip_area = 0, work = 0, residual = 0, y = 1, rotation = 1, back = 0;
        REQUIRE(contactd_get_counts(contact, &all, &adhesion, &slip, &border) == CONTACTD_OK);
        CHECK(all == solution.elements.contact);
        CHECK(adhesion == solution.elements.adhesion);
        CHECK(slip == solution.elements.slip);
        CHECK(border == solution.elements.border);
        REQUIRE(contactd_get_areas(contact, &area, &adhesion_area, &slip_area) == CONTACTD_OK);
        CHECK(area == solution.area.contact);
        CHECK(adhesion_area == solution.area.adhesion);
        CHECK(slip_area == solution.area.slip);
        REQUIRE(contactd_get_frictional_work(contact, &work) == CONTACTD_OK);
        CHECK(work == *solution.frictional_work);
        REQUIRE(contactd_get_step(contact, &number) == CONTACTD_OK);
        CHECK(number == session.step_number());
        REQUIRE(contactd_get_shift(contact, &back, &y, &rotation) == CONTACTD_OK);
        CHECK(back == x);
        REQUIRE(contactd_get_evidence(contact, CONTACTD_TANGENTIAL, &ran, &residual, &converged) == CONTACTD_OK);
        CHECK(ran == solution.evidence.tangential->iterations);
        CHECK(residual == solution.evidence.tangential->residual);
        CHECK(converged == 1);
        REQUIRE(contactd_get_converged(contact, &converged) == CONTACTD_OK);
        CHECK(converged == 1);
        REQUIRE(contactd_get_warnings(contact, &warnings) == CONTACTD_OK);
        REQUIRE(warnings == static_cast<std::int32_t>(solution.warnings.size()));
        CHECK(contactd_get_evidence(contact, CONTACTD_FORCE, &ran, &residual, &converged) == CONTACTD_NOT_FOUND);
        CHECK(contactd_get_creepages(contact, &back, &y, &rotation) == CONTACTD_NOT_FOUND);
        CHECK(contactd_get_frictional_power(contact, &work) == CONTACTD_NOT_FOUND);
    }
    char origin[20];
    REQUIRE(contactd_get_origin(contact, CONTACTD_LOWER, origin, 20) == CONTACTD_OK);
    CHECK(origin == std::string("memory"));  // the session before had it made
    CHECK(contactd_get_origin(contact, CONTACTD_PAIR, origin, 20) == CONTACTD_NOT_FOUND);
}

TEST_CASE("A contact in C rolls under a force as one in C++ does, and starts from what it found", "[c]") {
    Both both;
    contactd::SessionSpec spec = sphere();
    spec.setup.friction = contactd::FrictionLaw{{0.3}};
    contactd::Rolling rolling;
    rolling.eta = 1e-3;
    rolling.phi = 2e-3;
    rolling.force.Fx = -1;
    spec.load.motion = rolling;
    contactd::client::Session session(both.client, spec);
    const Handle contact(both.place);
    set_sphere(contact);
    REQUIRE(contactd_set_Fx(contact, -1) == CONTACTD_OK);  // in any order
    REQUIRE(contactd_set_rolling(contact, CONTACTD_STEADY, 0, 1e-3, 2e-3) == CONTACTD_OK);
    REQUIRE(contactd_set_mu(contact, 0.3) == CONTACTD_OK);
    require_ok(contactd_start(contact), contact);

    const auto compare = [&](const contactd::StepInput& input) {
        const contactd::ContactSolution solution = session.step(input).solution;
        CHECK(stepped(contact) == read(solution));
        double xi = 0, eta = 0, phi = 0, power = 0;
        REQUIRE(contactd_get_creepages(contact, &xi, &eta, &phi) == CONTACTD_OK);
        const auto& found = std::get<contactd::Rolling>(*solution.motion);
        CHECK(xi == found.xi);
        CHECK(eta == 1e-3);
        CHECK(phi == 2e-3);
        REQUIRE(contactd_get_frictional_power(contact, &power) == CONTACTD_OK);
        CHECK(power == *solution.frictional_power);
        std::int32_t iterations = 0, converged = 0;
        double residual = 0;
        REQUIRE(contactd_get_evidence(contact, CONTACTD_FORCE, &iterations, &residual, &converged) == CONTACTD_OK);
        CHECK(iterations == solution.evidence.force->iterations);
        return found.xi;
    };
    const double first = compare({});
    CHECK(first > 0);
    contactd::StepInput more;
    more.motion = rolling;
    std::get<contactd::Rolling>(*more.motion).force.Fx = -1.2;
    std::get<contactd::Rolling>(*more.motion).xi = 0;  // said once more by both: the estimate that was set
    REQUIRE(contactd_set_Fx(contact, -1.2) == CONTACTD_OK);
    const double second = compare(more);
    CHECK(second > first);
    std::get<contactd::Rolling>(*more.motion).xi = second;  // the C interface takes over what it has found
    compare(more);
}

TEST_CASE("A contact goes back to a state, its results with it, and comes to the same", "[c]") {
    Both both;
    const Handle contact(both.place);
    set_sphere(contact);
    REQUIRE(contactd_set_mu(contact, 0.4) == CONTACTD_OK);
    REQUIRE(contactd_set_shift(contact, 0.004, 0, 0) == CONTACTD_OK);
    REQUIRE(contactd_want(contact, "traction_x", 1) == CONTACTD_OK);
    require_ok(contactd_start(contact), contact);
    std::int32_t start = 0, state = 0, number = -1;
    REQUIRE(contactd_save(contact, &start) == CONTACTD_OK);
    const Read first = stepped(contact);
    REQUIRE(contactd_save(contact, &state) == CONTACTD_OK);
    CHECK(state != start);
    const Read second = stepped(contact);
    const auto tractions = get_array(contact, "traction_x");

    REQUIRE(contactd_restore(contact, state) == CONTACTD_OK);

    CHECK(read(contact) == first);
    REQUIRE(contactd_get_step(contact, &number) == CONTACTD_OK);
    CHECK(number == 1);
    CHECK(stepped(contact) == second);
    CHECK(get_array(contact, "traction_x") == tractions);
    CHECK(first != second);
    REQUIRE(contactd_restore(contact, start) == CONTACTD_OK);
    double pmax = 0;
    CHECK(contactd_get_pmax(contact, &pmax) == CONTACTD_FAILED_PRECONDITION);
    CHECK(stepped(contact) == first);
    REQUIRE(contactd_forget(contact, state) == CONTACTD_OK);
    CHECK(contactd_restore(contact, state) == CONTACTD_NOT_FOUND);
    CHECK(contactd_last_reason(contact) == std::string("STATE_UNKNOWN"));
}

TEST_CASE("Coefficients that are given serve a body, and the pair", "[c]") {
    Both both;
    contactd::IcSpec spec;
    spec.material = {200, 0.42};
    spec.dx = spec.dy = 0.2;
    spec.nx = spec.ny = across;
    const contactd::IcTable table = both.client.get_ic(spec).table;
    const contactd::IcTable pair = pair_of(table, table);
    const auto count = static_cast<std::int32_t>(table.values.size());
    const Handle made(both.place), of_bodies(both.place), of_pair(both.place);
    for (contactd_contact* contact : {static_cast<contactd_contact*>(made), static_cast<contactd_contact*>(of_bodies),
                                      static_cast<contactd_contact*>(of_pair)})
        set_sphere(contact);
    REQUIRE(contactd_set_table(of_bodies, CONTACTD_BOTH, across, across, 0.2, 0.2, table.values.data(), count) == 0);
    REQUIRE(contactd_set_table(of_pair, CONTACTD_PAIR, across, across, 0.2, 0.2, pair.values.data(), count) == 0);
    for (contactd_contact* contact : {static_cast<contactd_contact*>(made), static_cast<contactd_contact*>(of_bodies),
                                      static_cast<contactd_contact*>(of_pair)})
        require_ok(contactd_start(contact), contact);

    const Read expected = stepped(made);

    CHECK(stepped(of_bodies) == expected);
    CHECK(stepped(of_pair).Fn == Approx(expected.Fn).epsilon(1e-9));
    char origin[20];
    REQUIRE(contactd_get_origin(of_pair, CONTACTD_PAIR, origin, 20) == CONTACTD_OK);
    CHECK(origin == std::string("given"));
}

TEST_CASE("A step that does not converge leaves the contact where it was, or counts where that is accepted", "[c]") {
    Both both;
    for (const std::int32_t accepts : {0, 1}) {
        const Handle contact(both.place);
        set_sphere(contact);
        REQUIRE(contactd_set_tolerance(contact, CONTACTD_NORMAL, 1e-14, 1) == CONTACTD_OK);
        REQUIRE(contactd_set_accept_unconverged(contact, accepts) == CONTACTD_OK);
        require_ok(contactd_start(contact), contact);
        std::int32_t number = -1, converged = 1;
        if (accepts == 1) {
            require_ok(contactd_step(contact), contact);
            REQUIRE(contactd_get_converged(contact, &converged) == CONTACTD_OK);
            CHECK(converged == 0);
            continue;
        }
        CHECK(contactd_step(contact) == CONTACTD_ABORTED);
        CHECK(contactd_last_reason(contact) == std::string("NOT_CONVERGED"));
        REQUIRE(contactd_get_step(contact, &number) == CONTACTD_OK);
        CHECK(number == 0);
    }
}

#ifdef BUILDER
TEST_CASE("A block's coefficients are built while the contact starts, and the log says how far they are", "[c]") {
    Both both;
    std::vector<std::string> lines;
    const contactd_log keep = [](void* user, std::int32_t level, const char* text) {
        if (level == CONTACTD_LOG_INFO) static_cast<std::vector<std::string>*>(user)->emplace_back(text);
    };
    require_ok(contactd_set_log(both.place, keep, &lines), both.place);
    const Handle contact(both.place);
    set_sphere(contact);
    require_ok(contactd_set_fem(contact, CONTACTD_BOTH, CONTACTD_BLOCK, CONTACTD_CONSTANT, 0.05, 40), contact);
    require_ok(contactd_start(contact), contact);
    const Read found = stepped(contact);
    char origin[20];
    require_ok(contactd_get_origin(contact, CONTACTD_UPPER, origin, 20), contact);

    CHECK(origin == std::string("built"));
    REQUIRE_FALSE(lines.empty());
    CHECK(lines[0].starts_with("Waiting for influence coefficients: "));
    contactd::SessionSpec spec = sphere();
    contactd::Ics block;
    block.source = contactd::IcSource::fem;
    block.body = contactd::BodyShape::block;
    block.accuracy = 0.05;
    block.fem.L_over_h = 40;
    spec.setup.bodies = contactd::Bodies::of({{200, 0.42}, {200, 0.42}}, block);
    CHECK(found == read(contactd::client::Session(both.client, spec).step({}).solution));
    const Handle half_space(both.place);
    set_sphere(half_space);
    require_ok(contactd_start(half_space), half_space);
    CHECK(found.Fn > stepped(half_space).Fn);  // it is clamped
}
#endif
