// What the C interface refuses, whatever comes in. No daemon: nothing here gets as far.
#include <catch2/catch_test_macros.hpp>

#include <fstream>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

#include "every_call.hpp"

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();

/// Nobody listens there.
struct Nowhere {
    Place place{"ipc:///nowhere/contactd", 0.05};
    Handle contact{place};
};

std::string field() {
    return contactd_last_field(nullptr);
}
std::string reason() {
    return contactd_last_reason(nullptr);
}

/// Functions that the header declares and that take a contact first.
std::set<std::string> declared_calls() {
    std::ifstream file(HEADER);
    std::stringstream text;
    text << file.rdbuf();
    const std::string header = text.str();
    const std::regex declaration(R"((contactd_\w+)\(contactd_contact\* contact)");
    std::set<std::string> names;
    for (std::sregex_iterator at(header.begin(), header.end(), declaration), end; at != end; ++at)
        names.insert((*at)[1]);
    return names;
}

}  // namespace

extern "C" int words_in_c(void);

TEST_CASE("The words are the same in C and in C++", "[c]") {
    CHECK(words_in_c() == CONTACTD_SLIP);
    CHECK(std::string(contactd_code_name(CONTACTD_INVALID_ARGUMENT)) == "INVALID_ARGUMENT");
    CHECK(std::string(contactd_code_name(-7)) == "UNKNOWN");
    CHECK(std::string(contactd_code_name(77)) == "UNKNOWN");
    CHECK(contactd_version_number() ==
          10000 * CONTACTD_VERSION_MAJOR + 100 * CONTACTD_VERSION_MINOR + CONTACTD_VERSION_PATCH);
    CHECK(contactd_version() == std::to_string(CONTACTD_VERSION_MAJOR) + "." + std::to_string(CONTACTD_VERSION_MINOR) +
                                    "." + std::to_string(CONTACTD_VERSION_PATCH));
}

TEST_CASE("Every function that takes a contact is called by these tests", "[c]") {
    Arguments arguments;
    std::set<std::string> called;
    for (const auto& [name, call] : every_call(arguments)) called.insert(name);
    CHECK(called == declared_calls());
    CHECK(called.size() > 50);
}

TEST_CASE("A handle that is none is refused by every function", "[c]") {
    Nowhere nowhere;
    contactd_contact* freed = nullptr;
    REQUIRE(contactd_new(nowhere.place, &freed) == CONTACTD_OK);
    REQUIRE(contactd_free(freed) == CONTACTD_OK);
    contactd_connection* const place = nowhere.place;
    int elsewhere = 0;
    Arguments arguments;
    for (void* handle : {static_cast<void*>(nullptr), static_cast<void*>(freed), static_cast<void*>(place),
                         static_cast<void*>(&elsewhere)})
        for (const auto& [name, call] : every_call(arguments)) {
            INFO(name);
            CHECK(call(static_cast<contactd_contact*>(handle)) == CONTACTD_INVALID_ARGUMENT);
            CHECK(field() == "contact");
            CHECK(reason() == "NO_HANDLE");
            CHECK(contactd_last_error(handle) != std::string());
        }
}

TEST_CASE("A connection that is none is refused", "[c]") {
    contactd_connection* closed = nullptr;
    contactd_contact* contact = reinterpret_cast<contactd_contact*>(&closed);
    REQUIRE(contactd_open("ipc:///nowhere/contactd", &closed) == CONTACTD_OK);
    REQUIRE(contactd_close(closed) == CONTACTD_OK);
    for (contactd_connection* place : {static_cast<contactd_connection*>(nullptr), closed}) {
        CHECK(contactd_close(place) == CONTACTD_INVALID_ARGUMENT);
        CHECK(field() == "connection");
        CHECK(contactd_ping(place) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_timeout(place, 1) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_build_timeout(place, 1) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_connect_timeout(place, 1) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_keys(place, "a", "b") == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_log(place, nullptr, nullptr) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_new(place, &contact) == CONTACTD_INVALID_ARGUMENT);
    }
}

TEST_CASE("A place that is none is refused, and the library that has another one is named", "[c]") {
    contactd_connection* connection = nullptr;
    for (const char* where : {"", "nowhere", "http://a", "tcp://", "ipc:/x"}) {
        INFO(where);
        connection = reinterpret_cast<contactd_connection*>(&connection);
        CHECK(contactd_open(where, &connection) == CONTACTD_INVALID_ARGUMENT);
        CHECK(field() == "where");
        CHECK(connection == nullptr);
    }
    CHECK(contactd_open(nullptr, &connection) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_open("ipc:///x", nullptr) == CONTACTD_INVALID_ARGUMENT);
    if (contactd_has_local() == 1) return;
    CHECK(contactd_open("local", &connection) == CONTACTD_UNIMPLEMENTED);
    CHECK(std::string(contactd_last_error(nullptr)).find("-lcontactd-local") != std::string::npos);
}

TEST_CASE("Pointers that are NULL are refused by name", "[c]") {
    Nowhere nowhere;
    contactd_contact* const c = nowhere.contact;
    const double one[9] = {};
    CHECK(contactd_new(nowhere.place, nullptr) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_set_keys(nowhere.place, nullptr, "b") == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_set_keys(nowhere.place, "a", nullptr) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_set_gap(c, nullptr, 4) == CONTACTD_INVALID_ARGUMENT);
    CHECK(field() == "gap.array");
    CHECK(contactd_set_mu_array(c, nullptr, 4) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_set_table(c, CONTACTD_BOTH, 1, 1, 1, 1, nullptr, 9) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_set_previous(c, nullptr, one, one, 4) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_set_previous(c, one, nullptr, one, 4) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_set_previous(c, one, one, nullptr, 4) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_set_rigid_slip(c, nullptr, one, 4) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_set_rigid_slip(c, one, nullptr, 4) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_save(c, nullptr) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_get_step(c, nullptr) == CONTACTD_INVALID_ARGUMENT);
    CHECK(field() == "step");
}

TEST_CASE("What is no number is refused by the name that it has on the wire", "[c]") {
    Nowhere nowhere;
    contactd_contact* const c = nowhere.contact;
    const auto refused = [&](std::int32_t code, const std::string& name) {
        CHECK(code == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(c) == name);
        CHECK(contactd_last_reason(c) == std::string("FIELD_INVALID"));
    };
    for (const double bad : {nan, infinite, -infinite}) {
        refused(contactd_set_grid(c, 2, 2, bad, 1, 0, 0), "grid.dx");
        refused(contactd_set_grid(c, 2, 2, 1, 1, 0, bad), "grid.y0");
        refused(contactd_set_grid_centred(c, 2, 2, 1, bad), "grid.dy");
        refused(contactd_set_material(c, CONTACTD_BOTH, bad, 0.3), "G");
        refused(contactd_set_material(c, CONTACTD_BOTH, 1, bad), "nu");
        refused(contactd_set_fem(c, CONTACTD_BOTH, 0, 0, bad, 0), "ics.accuracy");
        refused(contactd_set_fem(c, CONTACTD_BOTH, 0, 0, 0.01, bad), "ics.L_over_h");
        refused(contactd_set_line_contact(c, bad), "ics.line_contact.datum");
        refused(contactd_set_tolerance(c, CONTACTD_NORMAL, bad, 1), "tolerance");
        refused(contactd_set_lease(c, bad), "lease_seconds");
        refused(contactd_set_approach(c, bad), "approach");
        refused(contactd_set_Fn(c, bad), "Fn");
        refused(contactd_set_semi_axes(c, bad, 1), "gap.semi_axes.a");
        refused(contactd_set_semi_axes(c, 1, bad), "gap.semi_axes.b");
        refused(contactd_set_mu(c, bad), "friction.mu");
        refused(contactd_set_kinetic(c, 0, bad, 1), "friction.kinetic.mu");
        refused(contactd_set_kinetic(c, 0, 0, bad), "friction.kinetic.slip_velocity");
        refused(contactd_set_shift(c, bad, 0, 0), "friction.rigid_shift");
        refused(contactd_set_shift(c, 0, bad, 0), "friction.rigid_shift");
        refused(contactd_set_shift(c, 0, 0, bad), "friction.rotation");
        refused(contactd_set_duration(c, bad), "friction.duration");
        refused(contactd_set_rolling(c, 0, bad, 0, 0), "friction.rolling.xi");
        refused(contactd_set_rolling(c, 0, 0, bad, 0), "friction.rolling.eta");
        refused(contactd_set_rolling(c, 0, 0, 0, bad), "friction.rolling.phi");
        refused(contactd_set_direction(c, bad, 0), "friction.rolling.chi");
        refused(contactd_set_direction(c, 0, bad), "friction.rolling.dq");
        refused(contactd_set_spin_offset(c, bad), "friction.rolling.spin_offset");
        refused(contactd_set_velocity(c, bad), "friction.rolling.velocity");
        refused(contactd_set_Fx(c, bad), "friction.force");
        refused(contactd_set_Fy(c, bad), "friction.force");
        refused(contactd_set_step_timeout(c, bad), "seconds");
        CHECK(contactd_set_timeout(nowhere.place, bad) == CONTACTD_INVALID_ARGUMENT);
    }
    refused(contactd_set_paraboloid(c, nan, 1), "gap.paraboloid.Rx");
    refused(contactd_set_paraboloid(c, 1, nan), "gap.paraboloid.Ry");
    CHECK(contactd_set_paraboloid(c, infinite, 1) == CONTACTD_OK);
}

TEST_CASE("Words and lengths that are none are refused", "[c]") {
    Nowhere nowhere;
    contactd_contact* const c = nowhere.contact;
    const double one[9] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    for (const std::int32_t bad :
         {-1, 77, std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::min()}) {
        CHECK(contactd_set_material(c, bad, 1, 0) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_rigid(c, bad) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_half_space(c, bad, 0) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_half_space(c, 0, bad) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_fem(c, 0, bad, 0, 0.01, 0) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_model(c, bad) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_tolerance(c, bad, 0.1, 1) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_accept_unconverged(c, bad) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_rolling(c, bad, 0, 0, 0) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_kinetic(c, bad, 0, 1) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_table(c, 0, bad, bad, 1, 1, one, 9) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_set_table(c, bad, 1, 1, 1, 1, one, 9) == CONTACTD_INVALID_ARGUMENT);
        if (bad < 0) CHECK(contactd_set_gap(c, one, bad) == CONTACTD_INVALID_ARGUMENT);
        if (bad < 0) CHECK(contactd_set_grid(c, bad, 1, 1, 1, 0, 0) == CONTACTD_INVALID_ARGUMENT);
    }
    CHECK(contactd_set_rigid(c, CONTACTD_PAIR) == CONTACTD_INVALID_ARGUMENT);
}

TEST_CASE("What was not started cannot step, and what cannot be solved cannot start", "[c]") {
    Nowhere nowhere;
    contactd_contact* const c = nowhere.contact;
    double value = 0;
    std::int32_t state = 0;
    const auto out_of_order = [&](std::int32_t code) {
        CHECK(code == CONTACTD_FAILED_PRECONDITION);
        CHECK(contactd_last_reason(c) == std::string("WRONG_ORDER"));
    };
    out_of_order(contactd_step(c));
    out_of_order(contactd_save(c, &state));
    out_of_order(contactd_restore(c, 1));
    out_of_order(contactd_forget(c, 1));
    out_of_order(contactd_get_step(c, &state));
    CHECK(contactd_get_pmax(c, &value) == CONTACTD_FAILED_PRECONDITION);
    CHECK(contactd_last_reason(c) == std::string("NO_RESULT"));

    const auto refused = [&](const std::string& name) {
        CHECK(contactd_start(c) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(c) == name);
    };
    refused("grid.nx");
    REQUIRE(contactd_set_grid_centred(c, 2, 2, 1, 1) == CONTACTD_OK);
    refused("bodies.upper.G");
    REQUIRE(contactd_set_rigid(c, CONTACTD_BOTH) == CONTACTD_OK);
    CHECK(contactd_start(c) == CONTACTD_INVALID_ARGUMENT);
    REQUIRE(contactd_set_material(c, CONTACTD_BOTH, 200, 0.6) == CONTACTD_OK);
    refused("bodies.upper.nu");
    REQUIRE(contactd_set_material(c, CONTACTD_BOTH, 200, 0.3) == CONTACTD_OK);
    REQUIRE(contactd_set_Fx(c, 1) == CONTACTD_OK);
    refused("friction.mu");
    REQUIRE(contactd_set_mu(c, -1) == CONTACTD_OK);
    refused("friction.mu");
    REQUIRE(contactd_set_mu(c, 1) == CONTACTD_OK);
    const double gap[3] = {};
    REQUIRE(contactd_set_gap(c, gap, 3) == CONTACTD_OK);
    refused("gap.array");
    REQUIRE(contactd_set_paraboloid(c, 0, 1) == CONTACTD_OK);
    refused("gap.paraboloid.Rx");
    REQUIRE(contactd_set_paraboloid(c, 1, 1) == CONTACTD_OK);

    CHECK(contactd_start(c) == CONTACTD_UNAVAILABLE);  // all is well but for the daemon
    CHECK(std::string(contactd_last_error(c)).find("Nobody listens") != std::string::npos);
    CHECK(contactd_last_reason(c) == std::string("NO_CONNECTION"));
    CHECK(contactd_ping(nowhere.place) == CONTACTD_UNAVAILABLE);
}

TEST_CASE("A failure is told by its handle, and of each handle the last one", "[c]") {
    Place place("ipc:///nowhere/contactd");
    Handle one(place), other(place);
    CHECK(contactd_last_code(one) == CONTACTD_OK);
    CHECK(contactd_last_error(one) == std::string());
    CHECK(contactd_step(one) == CONTACTD_FAILED_PRECONDITION);
    CHECK(contactd_set_mu(other, nan) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_set_mu(other, 0.3) == CONTACTD_OK);  // what succeeds leaves the last failure
    CHECK(contactd_last_code(one) == CONTACTD_FAILED_PRECONDITION);
    CHECK(contactd_last_code(other) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(other) == std::string("friction.mu"));
    CHECK(contactd_last_field(one) == std::string());
    CHECK(contactd_last_code(place) == CONTACTD_OK);
    CHECK(contactd_last_code(nullptr) == CONTACTD_INVALID_ARGUMENT);
}
