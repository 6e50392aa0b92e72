// Tests fields of contacts by their paths: equivalent names are equal, kinds of motion are not mixed, and the set-up is
// fixed from the start on.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "c_contact.hpp"

namespace {

using Setting = std::function<void(contactd_contact*)>;

Setting numbers(std::vector<std::pair<std::string, double>> all) {
    return [=](contactd_contact* contact) { set(contact, all); };
}

Setting array(const std::string& path, const Numbers& values) {
    return [=](contactd_contact* contact) { set_array(contact, path, values); };
}

Setting words(std::vector<std::pair<std::string, std::string>> all) {
    return [=](contactd_contact* contact) {
        for (const auto& [path, word] : all) set_word(contact, path, word);
    };
}

Setting all_of(std::vector<Setting> settings) {
    return [=](contactd_contact* contact) {
        for (const Setting& setting : settings) setting(contact);
    };
}

Setting cleared(const std::string& path) {
    return [=](contactd_contact* contact) { clear(contact, path); };
}

const Setting shift = numbers({{"friction.mu", 0.4}, {"friction.rigid_shift.x", 0.004}});
const Setting rolling = numbers({{"friction.mu", 0.4}, {"friction.rolling.xi", 0.001}});

/// Returns the answer of a sphere's second step to these fields.
Read solved(const Setting& setting) {
    const Place place("local");
    const Handle contact(place);
    set_sphere(contact);
    setting(contact);
    require_ok(contactd_start(contact), contact);
    stepped(contact);
    return stepped(contact);
}

void refused(std::int32_t code, contactd_contact* contact, const std::string& field, const std::string& sentence) {
    CHECK(code == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(contact) == field);
    INFO(contactd_last_error(contact));
    CHECK(std::string(contactd_last_error(contact)).find(sentence) != std::string::npos);
}

}  // namespace

TEST_CASE("What is set of a contact means the same, whichever way it is named", "[c]") {
    const double corner = -0.5 * across * 0.2;
    const Numbers ones(elements, 1), mu(elements, 0.4);
    const auto [one_way, other_way] = GENERATE_COPY(table<Setting, Setting>(
        {{numbers({{"grid.x0", corner}, {"grid.y0", corner}}), [](contactd_contact*) {}},
         {all_of({numbers({{"grid.x0", 3}, {"grid.y0", -1}}), cleared("grid.x0"), cleared("grid.y0")}),
          [](contactd_contact*) {}},
         {numbers({{"bodies.lower.G", 200}, {"bodies.lower.nu", 0.42}}), [](contactd_contact*) {}},
         {numbers({{"bodies.lower.rigid", 1}, {"bodies.lower.G", 200}, {"bodies.lower.nu", 0.42}}),
          cleared("bodies.lower")},
         {array("friction.mu", mu), numbers({{"friction.mu", 0.4}})},
         {all_of({shift, array("friction.rigid_slip.x", ones), array("friction.rigid_slip.y", ones),
                  cleared("friction.rigid_slip")}),
          all_of({numbers({{"friction.rigid_shift.y", 0}}), shift})},
         {all_of({shift, cleared("friction.rigid_shift"), rolling}), rolling},
         {all_of({rolling, numbers({{"friction.rolling.force.Fx", 1}}), cleared("friction.rolling.force")}), rolling},
         {all_of({rolling, cleared("friction.rolling"), shift}), shift},
         {all_of({numbers({{"friction.force.Fx", 1}}), cleared("friction.force.Fx"), shift}), shift},
         {array("friction.rigid_shift", {0.004, 0}), numbers({{"friction.rigid_shift.x", 0.004}})},
         {all_of({shift, cleared("friction")}), [](contactd_contact*) {}},
         {numbers({{"friction.rolling.dq", 0.2}, {"friction.rolling.xi", 0.001}}),
          numbers({{"friction.rolling.dq", 0}, {"friction.rolling.xi", 0.001}})},
         {numbers({{"gap.paraboloid.Rx", 50}, {"gap.paraboloid.Ry", INFINITY}}),
          all_of({array("gap.paraboloid", {50, 1}), cleared("gap.paraboloid.Ry")})},
         {numbers({{"Fn", 5}, {"approach", 0.02}}), [](contactd_contact*) {}},
         {all_of({words({{"ics.source", "fem"}}), cleared("ics")}), words({{"ics.source", "analytic"}})},
         {words({{"ics.load_shape", "bilinear"}}),
          all_of(
              {numbers({{"bodies.lower.G", 200}, {"bodies.lower.nu", 0.42}}),
               words({{"bodies.upper.ics.load_shape", "bilinear"}, {"bodies.lower.ics.load_shape", "bilinear"}})})}}));
    const auto with_friction = [](const Setting& way) {
        return [=](contactd_contact* contact) {
            way(contact);
            set(contact, "friction.mu", 0.4);
        };
    };
    CHECK(solved(with_friction(one_way)) == solved(with_friction(other_way)));
}

TEST_CASE("The kind of motion that is named first stays until it is cleared", "[c]") {
    const Place place("local");
    const Handle contact(place);
    set(contact, "friction.rolling.xi", 0.001);
    const char* const field = "friction.rigid_shift.x";
    refused(contactd_set(contact, field, 0.1), contact, field, "contactd_clear with \"friction.rolling\" first");
    refused(contactd_set(contact, "friction.force.Fx", 1), contact, "friction.force.Fx", "the motion is rolling");
    clear(contact, "friction.rolling");
    set(contact, field, 0.1);
    refused(contactd_set(contact, "friction.rolling.phi", 0.1), contact, "friction.rolling.phi", "a shift");
}

TEST_CASE("Laws of wear and what they take off have paths", "[c]") {
    const Place place("local");
    const Handle contact(place);
    set_sphere(contact);
    numbers({{"friction.mu", 0.4}, {"friction.rolling.xi", 0.02}, {"friction.rolling.velocity", 2e4}})(contact);
    words({{"wear.laws[0].name", "energy"}, {"wear.laws[0].source", "a test"}, {"wear.laws[0].body", "lower"}})(
        contact);
    set(contact, {{"wear.laws[0].range.least", 0},
                  {"wear.laws[0].range.most", 1000},
                  {"wear.laws[0].energy.coefficient", 1e-3},
                  {"wear.laws[0].zones[0].factor", 0.5}});
    require_ok(contactd_start(contact), contact);
    stepped(contact);
    CHECK(get(contact, "wear.laws") == 1);
    CHECK(get(contact, "wear.rows") > 2);
    CHECK(get(contact, "wear.T_gamma") > 0);
    CHECK(std::abs(get(contact, "wear.laws[0].area") / (0.5e-6 * get(contact, "wear.T_gamma_with_spin")) - 1) < 1e-12);
}

TEST_CASE("Heat and temperatures of a contact have paths", "[c]") {
    const Place place("local");
    const Handle contact(place);
    set_sphere(contact);
    set(contact, {{"friction.mu", 0.3}, {"friction.rolling.xi", 0.02}, {"friction.rolling.velocity", 2e4}});
    set(contact, {{"temperature.upper.conductivity", 0.2}, {"temperature.lower.bulk_temperature", 50}});
    set(contact, {{"friction.temperature.change", -0.1},
                  {"friction.temperature.reference", 20},
                  {"friction.temperature.range", 100}});
    for (const char* array : {"upper_temperature", "lower_temperature", "traction_x", "pressure"})
        require_ok(contactd_want(contact, array, 1), contact);
    require_ok(contactd_start(contact), contact);
    (void)stepped(contact);
    const Numbers upper = get_array(contact, "upper_temperature"), lower = get_array(contact, "lower_temperature"),
                  traction = get_array(contact, "traction_x"), pressure = get_array(contact, "pressure");
    double largest = 0;
    for (std::size_t i = 0; i < upper.size(); ++i) {
        if (!(pressure[i] > 0)) continue;
        CHECK(upper[i] == lower[i]);
        CHECK(std::abs(traction[i]) <= 0.3 * pressure[i]);
        largest = std::max(largest, upper[i]);
    }
    CHECK(get(contact, "temperature.largest") == largest);
    CHECK(largest > 45);
    refused(contactd_set(contact, "friction.temperature.range", 0), contact, "friction.temperature.range", "is 0");
}

TEST_CASE("What is wrong or missing of a contact is refused by its path", "[c]") {
    const Place place("local");
    const Handle contact(place);
    refused(contactd_set(contact, "grid.nx", 0), contact, "grid.nx", "is 0");
    refused(contactd_set(contact, "griD.nx", 1), contact, "griD.nx", "there is no \"griD\", only grid, gap");
    refused(contactd_set(contact, "grid", 1), contact, "grid", "name one of its fields");
    refused(contactd_set(contact, "friction.mu", -1), contact, "friction.mu", "is -1");
    refused(contactd_set(contact, "gap.array", 1), contact, "gap.array", "");
    refused(contactd_set_word(contact, "model", "quick"), contact, "model", "one of full, hertz, fastsim");
    refused(contactd_set(contact, "bodies.upper.ics.accuracy", 1), contact, "bodies.upper.ics.accuracy", "0.1");
    refused(contactd_clear(contact, "grid.nx"), contact, "grid.nx", "is required");
    refused(contactd_set(contact, "forces.Fn", 1), contact, "forces.Fn", "only grid");

    set_sphere(contact);
    const auto start_refused = [&](const std::string& field, const std::string& sentence) {
        refused(contactd_start(contact), contact, field, sentence);
    };
    set(contact, "friction.rigid_shift.x", 0.1);
    start_refused("friction.mu", "is missing");
    clear(contact, "friction");
    set(contact, "bodies.lower.G", 200);
    start_refused("bodies.lower.nu", "is missing");
    clear(contact, "bodies.lower");
    set_word(contact, "bodies.upper.ics.source", "fem");
    set(contact, "bodies.upper.ics.order", 3);
    start_refused("bodies.upper.ics.accuracy", "contactd_clear");
    clear(contact, "bodies.upper.ics");
    require_ok(contactd_start(contact), contact);
}

TEST_CASE("The set-up of a contact stays from its start on, and its load does not", "[c]") {
    const Place place("local");
    const Handle contact(place);
    set_sphere(contact);
    shift(contact);
    double value = 0;
    CHECK(contactd_get(contact, "step", &value) == CONTACTD_FAILED_PRECONDITION);
    require_ok(contactd_start(contact), contact);
    for (const char* path : {"grid.nx", "bodies.upper.rigid", "settings.normal.tolerance", "lease_seconds"}) {
        CHECK(contactd_set(contact, path, 1) == CONTACTD_FAILED_PRECONDITION);
        CHECK(std::string(contactd_last_error(contact)).find(path) != std::string::npos);
    }
    CHECK(get(contact, "step") == 0);
    CHECK(get_word(contact, "ics.upper.origin") == "closed_form");
    const Read before = stepped(contact);
    set(contact, {{"friction.rigid_shift.x", -0.004}, {"Fn", 2 * before.Fn}});
    const Read after = stepped(contact);
    CHECK(after.Fx != before.Fx);
    CHECK(std::abs(after.Fn / before.Fn - 2) < 1e-6);
    CHECK(get(contact, "step") == 2);
    refused(contactd_clear(contact, "friction"), contact, "friction", "set it to 0");
    refused(contactd_clear(contact, "friction.mu"), contact, "friction.mu", "set it to 0");
    set(contact, "friction.mu", 0);
    CHECK(stepped(contact).Fx == 0);
}

TEST_CASE("Results of a contact are read by their paths", "[c]") {
    const Place place("local");
    const Handle contact(place);
    set_sphere(contact);
    rolling(contact);
    set(contact, {{"friction.rolling.force.Fx", 0.1}, {"derivatives", 1}});
    require_ok(contactd_start(contact), contact);
    require_ok(contactd_step(contact), contact);
    CHECK(get(contact, "converged") == 1);
    CHECK(get_word(contact, "evidence.discretisation.source") == "hertz");
    CHECK(get(contact, "motion.xi") != 0.001);
    CHECK(get(contact, "motion.force.Fx") == 0.1);
    CHECK(get_word(contact, "motion.kind") == "steady");
    CHECK(std::abs(get(contact, "forces.Fx") - 0.1) < 1e-4);
    CHECK(get(contact, "derivatives.Fy.eta") != 0);
    double value = 0;
    CHECK(contactd_get(contact, "motion.rigid_shift.x", &value) == CONTACTD_NOT_FOUND);
    CHECK(contactd_get(contact, "frictional_work", &value) == CONTACTD_NOT_FOUND);
    CHECK(contactd_get_array(contact, "pressure", &value, 1) == CONTACTD_FAILED_PRECONDITION);
    require_ok(contactd_want(contact, "pressure", 1), contact);
    require_ok(contactd_want(contact, "pressure_by_approach", 1), contact);
    CHECK(contactd_want(contact, "gap", 1) == CONTACTD_INVALID_ARGUMENT);
    require_ok(contactd_step(contact), contact);
    CHECK(get_array(contact, "pressure").size() == elements);
    CHECK(get_array(contact, "pressure_by_approach").size() == elements);
    set(contact, "derivatives", 0);
    require_ok(contactd_step(contact), contact);
    CHECK(contactd_get_array(contact, "pressure_by_approach", &value, 1) == CONTACTD_NOT_FOUND);
}

TEST_CASE("An id of a contact stands for an input and for the result of the same name", "[c]") {
    const Place place("local");
    const Handle contact(place);
    set_sphere(contact);
    std::int32_t approach = -1, Fn = -1, converged = -1;
    require_ok(contactd_path(contact, "approach", &approach), contact);
    require_ok(contactd_path(contact, "Fn", &Fn), contact);
    require_ok(contactd_path(contact, "converged", &converged), contact);
    require_ok(contactd_set_at(contact, approach, 0.03), contact);
    require_ok(contactd_start(contact), contact);
    require_ok(contactd_step(contact), contact);
    double value = 0;
    require_ok(contactd_get_at(contact, approach, &value), contact);
    CHECK(value == 0.03);
    refused(contactd_get_at(contact, Fn, &value), contact, "Fn", "is an input that cannot be read");
    refused(contactd_set_at(contact, converged, 1), contact, "converged", "a result that cannot be set");
}
