// Tests that the C interface has the same solutions as the C++ client through a daemon, to the last bit.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>

#include "c_contact.hpp"
#include "client/cpp/own_daemon.hpp"
#include "contactd/client/session.hpp"

using Catch::Approx;

namespace {

contactd::SessionSpec sphere_spec() {
    contactd::SessionSpec spec;
    spec.setup.grid = contactd::Grid::of_elements(across, across, 0.2, 0.2);
    spec.setup.bodies = {{200, 0.42}, {200, 0.42}};
    spec.load.gap = contactd::Paraboloid{50, 50};
    spec.load.approach = 0.02;
    return spec;
}

Read read(const contactd::ContactSolution& solution) {
    const contactd::Forces& forces = solution.forces;
    return {forces.Fn, forces.Fx, forces.Fy, forces.Mz, solution.approach, solution.pmax};
}

/// Holds a daemon, a C++ client and a C connection.
struct Both {
    Daemon daemon;
    contactd::client::Client client{daemon.endpoint(), {.connect_timeout = std::chrono::seconds(20)}};
    Place place{daemon.endpoint()};
};

}  // namespace

TEST_CASE("A contact in C shifts as one in C++ does, array by array", "[c]") {
    Both both;
    contactd::SessionSpec spec = sphere_spec();
    spec.setup.friction = contactd::FrictionLaw{{0.4}};
    contactd::Shift shift;
    shift.rigid_shift.x = 0.004;
    spec.load.motion = shift;
    contactd::client::Session session(both.client, spec);
    const Handle contact(both.place);
    set_sphere(contact);
    set(contact, {{"friction.mu", 0.4}, {"friction.rigid_shift.x", 0.004}});
    for (const char* array : every_array) REQUIRE(contactd_want(contact, array, 1) == CONTACTD_OK);
    require_ok(contactd_start(contact), contact);

    contactd::StepInput input;
    input.fields = contactd::all_solution_fields;
    for (const double x : {0.004, -0.007}) {
        shift.rigid_shift.x = x;
        input.motion = shift;
        const contactd::ContactSolution solution = session.step(input).solution;
        set(contact, "friction.rigid_shift.x", x);

        CHECK(stepped(contact) == read(solution));
        CHECK(get_array(contact, "pressure") == solution.pressure);
        CHECK(get_array(contact, "traction_x") == solution.traction_x);
        CHECK(get_array(contact, "traction_y") == solution.traction_y);
        CHECK(get_array(contact, "slip_x") == solution.slip_x);
        CHECK(get_array(contact, "slip_y") == solution.slip_y);
        CHECK(std::ranges::equal(get_array(contact, "element_division"), solution.element_division,
                                 [](double a, contactd::ElementState b) { return a == static_cast<int>(b); }));
        const contactd::Counts& elements_of = solution.elements;
        const contactd::Areas& area = solution.area;
        CHECK(get_array(contact, "elements") == Numbers{double(elements_of.contact), double(elements_of.adhesion),
                                                        double(elements_of.slip), double(elements_of.flow),
                                                        double(elements_of.border)});
        CHECK(get_array(contact, "area") == Numbers{area.contact, area.adhesion, area.slip, area.flow});
        CHECK(get(contact, "frictional_work") == *solution.frictional_work);
        CHECK(get(contact, "step") == static_cast<double>(session.step_number()));
        CHECK(get(contact, "motion.rigid_shift.x") == x);
        CHECK(get(contact, "evidence.tangential.iterations") == solution.evidence.tangential->iterations);
        CHECK(get(contact, "evidence.tangential.residual") == solution.evidence.tangential->residual);
        CHECK(get(contact, "evidence.tangential.converged") == 1);
        CHECK(get(contact, "converged") == 1);
        REQUIRE(get(contact, "warnings") == static_cast<double>(solution.warnings.size()));
        for (const char* path : {"evidence.force.iterations", "motion.xi", "frictional_power"})
            CHECK_FALSE(has(contact, path));
    }
    CHECK(get_word(contact, "ics.lower.origin") == "memory");  // the previous session had it computed
    char origin[20];
    CHECK(contactd_get_word(contact, "ics.pair.origin", origin, 20) == CONTACTD_NOT_FOUND);
}

TEST_CASE("A contact in C rolls under a force as one in C++ does, and starts from what it found", "[c]") {
    Both both;
    contactd::SessionSpec spec = sphere_spec();
    spec.setup.friction = contactd::FrictionLaw{{0.3}};
    contactd::Rolling rolling;
    rolling.eta = 1e-3;
    rolling.phi = 2e-3;
    rolling.force.Fx = -1;
    spec.load.motion = rolling;
    contactd::client::Session session(both.client, spec);
    const Handle contact(both.place);
    set_sphere(contact);
    set(contact, {{"friction.rolling.force.Fx", -1}, {"friction.rolling.eta", 1e-3}, {"friction.rolling.phi", 2e-3}});
    set(contact, "friction.mu", 0.3);
    require_ok(contactd_start(contact), contact);

    const auto compare = [&](const contactd::StepInput& input) {
        const contactd::ContactSolution solution = session.step(input).solution;
        CHECK(stepped(contact) == read(solution));
        const auto& found = std::get<contactd::Rolling>(*solution.motion);
        CHECK(get(contact, "motion.xi") == found.xi);
        CHECK(get(contact, "motion.eta") == 1e-3);
        CHECK(get(contact, "motion.phi") == 2e-3);
        CHECK(get(contact, "frictional_power") == *solution.frictional_power);
        CHECK(get(contact, "evidence.force.iterations") == solution.evidence.force->iterations);
        return found.xi;
    };
    const double first = compare({});
    CHECK(first > 0);
    contactd::StepInput more;
    more.motion = rolling;
    std::get<contactd::Rolling>(*more.motion).force.Fx = -1.2;
    std::get<contactd::Rolling>(*more.motion).xi = 0;  // both set the estimate again
    set(contact, "friction.rolling.force.Fx", -1.2);
    const double second = compare(more);
    CHECK(second > first);
    std::get<contactd::Rolling>(*more.motion).xi = second;  // the C interface uses the computed motion
    compare(more);
}

TEST_CASE("A contact goes back to a state, its results with it, and comes to the same", "[c]") {
    Both both;
    const Handle contact(both.place);
    set_sphere(contact);
    set(contact, {{"friction.mu", 0.4}, {"friction.rigid_shift.x", 0.004}});
    REQUIRE(contactd_want(contact, "traction_x", 1) == CONTACTD_OK);
    require_ok(contactd_start(contact), contact);
    std::int32_t start = 0, state = 0;
    REQUIRE(contactd_save(contact, &start) == CONTACTD_OK);
    const Read first = stepped(contact);
    REQUIRE(contactd_save(contact, &state) == CONTACTD_OK);
    CHECK(state != start);
    const Read second = stepped(contact);
    const auto tractions = get_array(contact, "traction_x");

    REQUIRE(contactd_restore(contact, state) == CONTACTD_OK);

    CHECK(read(contact) == first);
    CHECK(get(contact, "step") == 1);
    CHECK(stepped(contact) == second);
    CHECK(get_array(contact, "traction_x") == tractions);
    CHECK(first != second);
    REQUIRE(contactd_restore(contact, start) == CONTACTD_OK);
    double pmax = 0;
    CHECK(contactd_get(contact, "pmax", &pmax) == CONTACTD_FAILED_PRECONDITION);
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
    REQUIRE(contactd_set_table(of_bodies, "bodies.upper.ics", across, across, 0.2, 0.2, table.values.data(), count) ==
            0);
    REQUIRE(contactd_set_table(of_pair, "ics", across, across, 0.2, 0.2, pair.values.data(), count) == 0);
    for (contactd_contact* contact : {static_cast<contactd_contact*>(made), static_cast<contactd_contact*>(of_bodies),
                                      static_cast<contactd_contact*>(of_pair)})
        require_ok(contactd_start(contact), contact);

    const Read expected = stepped(made);

    CHECK(stepped(of_bodies) == expected);
    CHECK(stepped(of_pair).Fn == Approx(expected.Fn).epsilon(1e-9));
    CHECK(get_word(of_pair, "ics.pair.origin") == "given");
}

TEST_CASE("A step that does not converge leaves the contact where it was, or counts where that is accepted", "[c]") {
    Both both;
    for (const std::int32_t accepts : {0, 1}) {
        const Handle contact(both.place);
        set_sphere(contact);
        set(contact, {{"settings.normal.tolerance", 1e-14}, {"settings.normal.max_iterations", 1}});
        set(contact, "accept_unconverged", accepts);
        require_ok(contactd_start(contact), contact);
        if (accepts == 1) {
            require_ok(contactd_step(contact), contact);
            CHECK(get(contact, "converged") == 0);
            continue;
        }
        CHECK(contactd_step(contact) == CONTACTD_ABORTED);
        CHECK(contactd_last_reason(contact) == std::string("NOT_CONVERGED"));
        CHECK(get(contact, "step") == 0);
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
    set_word(contact, "ics.source", "fem");
    set_word(contact, "ics.body", "block");
    set(contact, {{"ics.accuracy", 0.05}, {"ics.L_over_h", 40}});
    require_ok(contactd_start(contact), contact);
    const Read found = stepped(contact);

    CHECK(get_word(contact, "ics.upper.origin") == "built");
    REQUIRE_FALSE(lines.empty());
    CHECK(lines[0].starts_with("Waiting for influence coefficients: "));
    contactd::SessionSpec spec = sphere_spec();
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
