// In process and behind a daemon a contact is the same, to the last bit; and so is what is refused.
#include <catch2/catch_test_macros.hpp>

#include <string>
#include <tuple>

#include "client/cpp/own_daemon.hpp"
#include "same_cases.hpp"

namespace {

/// All that a step tells.
struct Told {
    std::int32_t code = 0, step = 0;
    std::string field, reason;
    Read numbers;
    std::vector<double> values;        // creepages or shift, work or power, areas, evidence
    std::vector<std::int32_t> counts;  // of elements, iterations
    std::vector<std::vector<double>> arrays;
    std::vector<std::string> warnings;
    bool operator==(const Told&) const = default;
};

void read_evidence(contactd_contact* contact, Told& told) {
    for (std::int32_t solver = CONTACTD_NORMAL; solver <= CONTACTD_FORCE; ++solver) {
        double residual = -1;
        std::int32_t iterations = -1, converged = -1;
        told.counts.push_back(contactd_get_evidence(contact, solver, &iterations, &residual, &converged));
        told.counts.push_back(iterations);
        told.counts.push_back(converged);
        told.values.push_back(residual);
    }
    double errors[3] = {};
    std::int32_t across_contact = 0;
    contactd_get_discretisation(contact, &across_contact, errors, errors + 1, errors + 2);
    told.counts.push_back(across_contact);
    for (const double error : errors) told.values.push_back(error);
}

Told told_by(contactd_contact* contact) {
    Told told;
    told.code = contactd_step(contact);
    if (told.code != CONTACTD_OK) {
        told.field = contactd_last_field(contact);
        told.reason = contactd_last_reason(contact);
        return told;
    }
    contactd_get_step(contact, &told.step);
    told.numbers = read(contact);
    double values[8] = {};
    if (contactd_get_creepages(contact, values, values + 1, values + 2) != CONTACTD_OK)
        contactd_get_shift(contact, values, values + 1, values + 2);
    contactd_get_frictional_work(contact, values + 3);
    contactd_get_frictional_power(contact, values + 4);
    contactd_get_areas(contact, values + 5, values + 6, values + 7);
    told.values.assign(values, values + 8);
    std::int32_t counts[4] = {}, warnings = 0;
    contactd_get_counts(contact, counts, counts + 1, counts + 2, counts + 3);
    told.counts.assign(counts, counts + 4);
    read_evidence(contact, told);
    for (std::int32_t array = CONTACTD_PRESSURE; array <= CONTACTD_SLIP_Y; ++array)
        told.arrays.push_back(array_of(contact, array));
    contactd_get_warnings(contact, &warnings);
    for (std::int32_t i = 0; i < warnings; ++i) {
        char text[500];
        contactd_get_warning(contact, i, text, 500);
        told.warnings.emplace_back(text);
    }
    return told;
}

/// Every step of a case, with one of them gone back to.
std::vector<Told> answers(contactd_connection* place, const SameCase& same) {
    const Handle contact(place);
    set_sphere(contact);
    same.set_up(contact);
    for (std::int32_t array = CONTACTD_DIVISION; array <= CONTACTD_SLIP_Y; ++array)
        require_ok(contactd_want(contact, array, 1), contact);
    require_ok(contactd_start(contact), contact);
    std::vector<Told> all;
    for (const auto& before : same.steps) {
        before(contact);
        all.push_back(told_by(contact));
    }
    std::int32_t state = 0;
    require_ok(contactd_save(contact, &state), contact);
    all.push_back(told_by(contact));
    require_ok(contactd_restore(contact, state), contact);
    all.push_back(told_by(contact));
    CHECK(all[all.size() - 2] == all.back());
    return all;
}

}  // namespace

TEST_CASE("In process and behind a daemon every step is the same", "[c]") {
    REQUIRE(contactd_has_local() == 1);
    Daemon daemon;
    const Place remote(daemon.endpoint()), local("local");
    REQUIRE(contactd_ping(local) == CONTACTD_OK);
    for (const SameCase& same : same_cases()) {
        INFO(same.name);
        const std::vector<Told> here = answers(local, same), there = answers(remote, same);
        REQUIRE(here.size() == there.size());
        for (std::size_t i = 0; i < here.size(); ++i) {
            INFO("step " << i + 1 << " " << here[i].field << " | " << there[i].field);
            CHECK(here[i].code == CONTACTD_OK);
            CHECK(here[i] == there[i]);
        }
    }
}

TEST_CASE("In process and behind a daemon the same is refused, by code, field and sentence", "[c]") {
    Daemon daemon;
    const Place remote(daemon.endpoint()), local("local");
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
