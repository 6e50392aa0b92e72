// In process and behind a daemon the same is refused; that the same is answered, tests/congruence holds.
#include <catch2/catch_test_macros.hpp>

#include <functional>
#include <string>
#include <tuple>

#include "c_contact.hpp"
#include "client/cpp/own_daemon.hpp"

TEST_CASE("In process and behind a daemon the same is refused, by code, field and sentence", "[c]") {
    Daemon daemon;
    const Place remote(daemon.endpoint()), local("local");
    REQUIRE(contactd_has_local() == 1);
    REQUIRE(contactd_ping(local) == CONTACTD_OK);
    const std::vector<std::pair<std::string, std::function<void(contactd_contact*)>>> bad{
        {"mu", [](contactd_contact* c) { contactd_set_mu(c, -0.1); }},
        {"gap", [](contactd_contact* c) { contactd_set_paraboloid(c, 0, 50); }},
        {"gap of another size",
         [](contactd_contact* c) {
             const double gap[2] = {};
             contactd_set_gap(c, gap, 2);
         }},
        {"material", [](contactd_contact* c) { contactd_set_material(c, CONTACTD_LOWER, 200, 0.7); }},
        {"stiff", [](contactd_contact* c) { contactd_set_rigid(c, CONTACTD_BOTH); }},
        {"Fn", [](contactd_contact* c) { contactd_set_Fn(c, -1); }},
        {"table",
         [](contactd_contact* c) {
             const double table[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
             contactd_set_table(c, CONTACTD_BOTH, 1, 1, 0.2, 0.2, table, 9);
         }},
        {"tolerance", [](contactd_contact* c) { contactd_set_tolerance(c, CONTACTD_OUTER, 2, 10); }},
        {"incompressible",
         [](contactd_contact* c) {
             contactd_set_material(c, CONTACTD_UPPER, 200, 0.5);
             contactd_set_fem(c, CONTACTD_UPPER, 0, 0, 0.01, 0);
         }},
        {"block", [](contactd_contact* c) { contactd_set_fem(c, CONTACTD_UPPER, CONTACTD_BLOCK, 0, 0.01, -5); }},
        {"layer",
         [](contactd_contact* c) {
             const double thickness = 0, G = 20, nu = 0.3;
             contactd_set_layers(c, CONTACTD_LOWER, CONTACTD_CONSTANT, &thickness, &G, &nu, 1, 0, 0);
         }},
        {"quick layers",
         [](contactd_contact* c) {
             const double thickness = 1, G = 20, nu = 0.3;
             contactd_set_layers(c, CONTACTD_LOWER, CONTACTD_CONSTANT, &thickness, &G, &nu, 1, 300, 0.3);
             contactd_set_model(c, CONTACTD_HERTZ);
         }},
        {"line", [](contactd_contact* c) { contactd_set_line_contact(c, 10); }},
        {"dq",
         [](contactd_contact* c) {
             contactd_set_mu(c, 0.3);
             contactd_set_rolling(c, 0, 0, 0, 0);
             contactd_set_direction(c, 0, -1);
         }},
        {"force",
         [](contactd_contact* c) {
             contactd_set_mu(c, 0.3);
             contactd_set_Fx(c, 1e6);
         }},
        {"quick",
         [](contactd_contact* c) {
             contactd_set_model(c, CONTACTD_HERTZ);
             const std::vector<double> gap(elements, 1);
             contactd_set_gap(c, gap.data(), elements);
         }},
        {"nothing to refuse", [](contactd_contact*) {}},
    };
    int refused = 0;
    for (const auto& [name, set_up] : bad) {
        INFO(name);
        std::vector<std::tuple<std::int32_t, std::string, std::string, std::string>> told;
        for (contactd_connection* place :
             {static_cast<contactd_connection*>(remote), static_cast<contactd_connection*>(local)}) {
            const Handle contact(place);
            set_sphere(contact);
            set_up(contact);
            std::int32_t code = contactd_start(contact);
            if (code == CONTACTD_OK) code = contactd_step(contact);
            told.emplace_back(code, contactd_last_field(contact), contactd_last_reason(contact),
                              contactd_last_error(contact));
            refused += code != CONTACTD_OK;
        }
        INFO(std::get<3>(told[0]) << "\n" << std::get<3>(told[1]));
        CHECK(told[0] == told[1]);
    }
    CHECK(refused == 2 * static_cast<int>(bad.size() - 1));
}

TEST_CASE("A step in process ends at its timeout", "[c]") {
    const Place local("local");
    const Handle contact(local);
    set_sphere(contact);
    require_ok(contactd_set_grid_centred(contact, 60, 60, 0.04, 0.04), contact);
    require_ok(contactd_set_mu(contact, 0.3), contact);
    require_ok(contactd_set_rolling(contact, CONTACTD_TRANSIENT, 2e-3, 0, 1e-3), contact);
    require_ok(contactd_set_rolling_steps(contact, 100'000), contact);
    require_ok(contactd_set_step_timeout(contact, 0.05), contact);
    require_ok(contactd_start(contact), contact);
    CHECK(contactd_step(contact) == CONTACTD_DEADLINE_EXCEEDED);
    CHECK(contactd_last_reason(contact) == std::string("DEADLINE_PASSED"));
}
