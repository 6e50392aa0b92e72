// Tests that refusals are equal in process and with a daemon; tests/congruence compares answers.
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
    const auto set_layer = [](contactd_contact* c, double thickness) {
        clear(c, "bodies.upper");
        set_word(c, "bodies.upper.ics.body", "layered");
        set(c, {{"bodies.upper.ics.base.rigid", 1}, {"bodies.upper.ics.layers[0].thickness", thickness}});
        set(c, {{"bodies.upper.ics.layers[0].G", 20}, {"bodies.upper.ics.layers[0].nu", 0.3}});
    };
    const auto set_block = [](contactd_contact* c, const std::string& body) {
        set_word(c, "ics.source", "fem");
        set_word(c, "ics.body", body);
    };
    const std::vector<std::pair<std::string, std::function<void(contactd_contact*)>>> bad{
        {"gap", [](contactd_contact* c) { set(c, "gap.paraboloid.Rx", 0); }},
        {"gap of another size", [](contactd_contact* c) { set_array(c, "gap.array", {0, 0}); }},
        {"material", [](contactd_contact* c) { set(c, "bodies.upper.nu", 0.7); }},
        {"no material", [](contactd_contact* c) { clear(c, "bodies.upper"); }},
        {"half a material", [](contactd_contact* c) { set(c, "bodies.lower.G", 20); }},
        {"stiff", [](contactd_contact* c) { set(c, "bodies.upper.rigid", 1); }},
        {"table",
         [](contactd_contact* c) {
             const double table[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
             require_ok(contactd_set_table(c, "bodies.upper.ics", 1, 1, 0.2, 0.2, table, 9), c);
         }},
        {"incompressible",
         [&](contactd_contact* c) {
             set_block(c, "half_space");
             set(c, "bodies.upper.nu", 0.5);
         }},
        {"block in closed form",
         [&](contactd_contact* c) {
             set_block(c, "block");
             set_word(c, "ics.source", "analytic");
         }},
        {"mesh beside an accuracy",
         [&](contactd_contact* c) {
             set_block(c, "half_space");
             set(c, "ics.order", 3);
         }},
        {"layer", [&](contactd_contact* c) { set_layer(c, 1e-9); }},
        {"quick layers",
         [&](contactd_contact* c) {
             set_layer(c, 1);
             set_word(c, "model", "hertz");
         }},
        {"material beside layers",
         [&](contactd_contact* c) {
             set_layer(c, 1);
             set(c, "bodies.upper.G", 20);
         }},
        {"line", [](contactd_contact* c) { set(c, "ics.line_contact.datum", 10); }},
        {"force", [](contactd_contact* c) { set(c, {{"friction.mu", 0.3}, {"friction.force.Fx", 1e6}}); }},
        {"motion without friction", [](contactd_contact* c) { set(c, "friction.rolling.xi", 0.001); }},
        {"quick",
         [](contactd_contact* c) {
             set_word(c, "model", "hertz");
             set_array(c, "gap.array", Numbers(elements, 1));
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
    set_long(contact);
    require_ok(contactd_set_step_timeout(contact, 0.05), contact);
    require_ok(contactd_start(contact), contact);
    CHECK(contactd_step(contact) == CONTACTD_DEADLINE_EXCEEDED);
    CHECK(contactd_last_reason(contact) == std::string("DEADLINE_PASSED"));
}
