#include <catch2/catch_test_macros.hpp>

#include <stdexcept>

#include "contactd/status.hpp"

using namespace contactd;

TEST_CASE("Status codes have gRPC's names and numbers", "[status]") {
    CHECK(name_of(StatusCode::ok) == "OK");
    CHECK(name_of(StatusCode::invalid_argument) == "INVALID_ARGUMENT");
    CHECK(name_of(StatusCode::unauthenticated) == "UNAUTHENTICATED");
    CHECK(static_cast<int>(StatusCode::resource_exhausted) == 8);
    for (const char* name : {"OK", "INVALID_ARGUMENT", "UNAUTHENTICATED"}) CHECK(name_of(code_named(name)) == name);
    CHECK_THROWS_AS(code_named("FINE"), std::out_of_range);
}
