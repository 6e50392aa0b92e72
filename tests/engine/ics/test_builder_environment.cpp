#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <string>

#include "engine/ics/build/builder_environment.hpp"

using contactd::engine::passed_on;

TEST_CASE("Only variables that are named are passed on, by their whole name or its beginning") {
    ::setenv("CONTACTD_TEST_ONE", "1=2", 1);
    ::setenv("CONTACTD_TEST_TWO", "", 1);
    ::setenv("CONTACTD_TESTING", "3", 1);

    CHECK(passed_on({}).empty());
    CHECK(passed_on({"CONTACTD_TEST"}).empty());
    CHECK(passed_on({"CONTACTD_TEST_ONE"}) == contactd::engine::Environment{{"CONTACTD_TEST_ONE", "1=2"}});
    CHECK(passed_on({"CONTACTD_TEST_*"}).size() == 2);
    CHECK(passed_on({"CONTACTD_TEST*", "CONTACTD_TESTING"}).size() == 3);
    CHECK(passed_on({"CONTACTD_TEST_TWO", "NO_SUCH_VARIABLE"}).front().second.empty());
    for (const char* name : {"CONTACTD_TEST_ONE", "CONTACTD_TEST_TWO", "CONTACTD_TESTING"}) ::unsetenv(name);
}
