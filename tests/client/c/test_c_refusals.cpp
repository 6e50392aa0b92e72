// Tests refusals of the C interface for any input, without a daemon.
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

/// Returns functions of the header whose declaration begins with this text; by default those that take a contact first.
std::set<std::string> declared_calls(
    const std::string& begin = R"((contactd_\w+)\((?:contactd_contact\* contact|contactd_handle handle))") {
    std::ifstream file(HEADER);
    std::stringstream text;
    text << file.rdbuf();
    const std::string header = text.str();
    const std::regex declaration(begin);
    std::set<std::string> names;
    for (std::sregex_iterator at(header.begin(), header.end(), declaration), end; at != end; ++at)
        names.insert((*at)[1]);
    return names;
}

}  // namespace

extern "C" int words_in_c(void);

TEST_CASE("Enumerators are the same in C and in C++", "[c]") {
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
    CHECK(called.size() > 20);
}

TEST_CASE("A handle that is none is refused by every function", "[c]") {
    Nowhere nowhere;
    contactd_contact* freed = nullptr;
    REQUIRE(contactd_new(nowhere.place, &freed) == CONTACTD_OK);
    REQUIRE(contactd_free(freed) == CONTACTD_OK);
    contactd_connection* const place = nowhere.place;
    int elsewhere = 0;
    Arguments arguments;
    const std::set<std::string> takes_wheels = declared_calls(R"((contactd_\w+)\(contactd_handle handle)");
    for (void* handle : {static_cast<void*>(nullptr), static_cast<void*>(freed), static_cast<void*>(place),
                         static_cast<void*>(&elsewhere)})
        for (const auto& [name, call] : every_call(arguments)) {
            INFO(name);
            CHECK(call(static_cast<contactd_contact*>(handle)) == CONTACTD_INVALID_ARGUMENT);
            CHECK(field() == (takes_wheels.contains(name) ? "handle" : "contact"));
            CHECK(reason() == "NO_HANDLE");
            CHECK(contactd_last_error(handle) != std::string());
        }
}

TEST_CASE("A table that is none is refused by every function", "[c]") {
    int elsewhere = 0;
    double values[9] = {};
    for (void* handle : {static_cast<void*>(nullptr), static_cast<void*>(&elsewhere)}) {
        auto* const table = static_cast<contactd_creep_table*>(handle);
        const std::int32_t codes[] = {
            contactd_creep_table_close(table), contactd_creep_table_info(table, values, values, nullptr, 0),
            contactd_creep_table_forces(table, 1, 1, 1, 1, 1, values, values + 3, nullptr, nullptr),
            contactd_creep_table_many(table, 0, nullptr, nullptr, nullptr, nullptr, nullptr)};
        for (const std::int32_t code : codes) CHECK(code == CONTACTD_INVALID_ARGUMENT);
        CHECK(field() == "table");
        CHECK(reason() == "NO_HANDLE");
    }
    contactd_creep_table* table = nullptr;
    CHECK(contactd_creep_table_open("none.creep", 0.28, &table) ==
          (contactd_has_local() ? CONTACTD_NOT_FOUND : CONTACTD_UNIMPLEMENTED));
    CHECK(contactd_creep_table_open(nullptr, 0.28, &table) == CONTACTD_INVALID_ARGUMENT);
    CHECK(field() == "path");
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
    const auto refused = [&](std::int32_t code, const std::string& name) {
        CHECK(code == CONTACTD_INVALID_ARGUMENT);
        CHECK(field() == name);
    };
    double value = 0;
    refused(contactd_set(c, nullptr, 1), "path");
    refused(contactd_set_word(c, "model", nullptr), "keyword");
    refused(contactd_set_array(c, "gap.array", nullptr, 4), "values");
    refused(contactd_set_array(c, nullptr, one, 4), "path");
    refused(contactd_set_table(c, nullptr, 1, 1, 1, 1, one, 9), "path");
    refused(contactd_set_table(c, "ics", 1, 1, 1, 1, nullptr, 9), "values");
    refused(contactd_get_frames(c, nullptr, &value, &value, &value, 1), "body");
    refused(contactd_read_profile(c, "ics.section.profile_section.profile", nullptr), "file");
    refused(contactd_save(c, nullptr), "state");
    refused(contactd_path(c, "Fn", nullptr), "id");
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
        for (const char* path :
             {"grid.dx", "bodies.upper.G", "bodies.lower.nu", "ics.accuracy", "ics.L_over_h", "ics.line_contact.datum",
              "settings.normal.tolerance", "lease_seconds", "approach", "Fn", "gap.semi_axes.a", "friction.mu",
              "friction.kinetic.mu", "friction.rolling.xi", "friction.rolling.dq", "friction.rolling.force.Fx",
              "ics.section.size", "columns.direction", "bodies.lower.ics.section.groove.depth"})
            refused(contactd_set(c, path, bad), path);
        const double array[] = {1, bad};
        refused(contactd_set_array(c, "gap.array", array, 2), "gap.array");
        refused(contactd_set_array(c, "columns.origin", array, 2), "columns.origin.z");
        refused(contactd_set_array(c, "ics.section.outline.outside.parts[0].spline.through", array, 2),
                "ics.section.outline.outside.parts[0].spline.through[0].z");
        refused(contactd_set_step_timeout(c, bad), "seconds");
        CHECK(contactd_set_timeout(nowhere.place, bad) == CONTACTD_INVALID_ARGUMENT);
    }
    refused(contactd_set(c, "gap.paraboloid.Rx", nan), "gap.paraboloid.Rx");
    CHECK(contactd_set(c, "gap.paraboloid.Rx", infinite) == CONTACTD_OK);
}

TEST_CASE("Lengths, tables and places of tables that cannot be are refused", "[c]") {
    Nowhere nowhere;
    contactd_contact* const c = nowhere.contact;
    const double one[9] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    for (const std::int32_t bad : {-1, 77, std::numeric_limits<std::int32_t>::min()}) {
        CHECK(contactd_set_table(c, "ics", bad, bad, 1, 1, one, 9) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(c) == std::string("count"));
        if (bad < 0) CHECK(contactd_set_array(c, "gap.array", one, bad) == CONTACTD_INVALID_ARGUMENT);
    }
    CHECK(contactd_set_table(c, "bodies.upper", 1, 1, 1, 1, one, 9) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(c) == std::string("bodies.upper"));
    CHECK(contactd_set_table(c, "ics", 1, 1, nan, 1, one, 9) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(c) == std::string("ics.dx"));
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
    out_of_order(contactd_get(c, "step", &value));
    CHECK(contactd_get(c, "pmax", &value) == CONTACTD_FAILED_PRECONDITION);
    CHECK(contactd_last_reason(c) == std::string("NO_RESULT"));

    const auto refused = [&](const std::string& name) {
        CHECK(contactd_start(c) == CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(c) == name);
    };
    refused("bodies.upper.G");
    set(c, "bodies.upper.rigid", 1);
    refused("grid.nx");
    set(c, {{"grid.nx", 2}, {"grid.ny", 2}, {"grid.dx", 1}, {"grid.dy", 1}});
    refused("bodies.lower");
    set(c, {{"bodies.upper.G", 200}, {"bodies.upper.nu", 0.6}});
    refused("bodies.upper.nu");
    set(c, {{"bodies.upper.nu", 0.3}, {"friction.force.Fx", 1}});
    refused("friction.mu");
    set(c, "friction.mu", 1);
    set_array(c, "gap.array", {0, 0, 0});
    refused("gap.array");
    set(c, {{"gap.paraboloid.Rx", 0}, {"gap.paraboloid.Ry", 1}});
    refused("gap.paraboloid.Rx");
    set(c, "gap.paraboloid.Rx", 1);

    CHECK(contactd_start(c) == CONTACTD_UNAVAILABLE);  // everything is valid except the daemon
    CHECK(std::string(contactd_last_error(c)).find("No daemon is listening") != std::string::npos);
    CHECK(contactd_last_reason(c) == std::string("NO_CONNECTION"));
    CHECK(contactd_ping(nowhere.place) == CONTACTD_UNAVAILABLE);
}

TEST_CASE("A failure is told by its handle, and of each handle the last one", "[c]") {
    Place place("ipc:///nowhere/contactd");
    Handle one(place), other(place);
    CHECK(contactd_last_code(one) == CONTACTD_OK);
    CHECK(contactd_last_error(one) == std::string());
    CHECK(contactd_step(one) == CONTACTD_FAILED_PRECONDITION);
    CHECK(contactd_set(other, "friction.mu", nan) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_set(other, "friction.mu", 0.3) == CONTACTD_OK);  // a successful call keeps the last failure
    CHECK(contactd_last_code(one) == CONTACTD_FAILED_PRECONDITION);
    CHECK(contactd_last_code(other) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(other) == std::string("friction.mu"));
    CHECK(contactd_last_field(one) == std::string());
    CHECK(contactd_last_code(place) == CONTACTD_OK);
    CHECK(contactd_last_code(nullptr) == CONTACTD_INVALID_ARGUMENT);
}
