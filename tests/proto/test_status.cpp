#include <catch2/catch_test_macros.hpp>

#include "contactd/proto/status.hpp"
#include "wire.hpp"

using namespace contactd::proto;
using nlohmann::json;

TEST_CASE("A status survives the wire", "[status]") {
    Status status{StatusCode::resource_exhausted, "The queue is full.", std::string(reason::queue_full), {}, 250};
    status.violations = {{"grid.nx", "is -1; it must be at least 1"}, {"approach", "is missing"}};

    const Status read = status_from_json(to_json(status));

    CHECK(read.code == status.code);
    CHECK(read.message == status.message);
    CHECK(read.reason == status.reason);
    CHECK(read.retry_delay_ms == 250);
    REQUIRE(read.violations.size() == 2);
    CHECK(read.violations[0].field == "grid.nx");
    CHECK(read.violations[1].description == "is missing");
}

TEST_CASE("A good status carries no details", "[status]") {
    CHECK(to_json(Status{}) == json{{"code", 0}, {"name", "OK"}, {"message", ""}});
}

TEST_CASE("What is no status is refused", "[status]") {
    for (const char* text : {"null", "[]", "{}", R"({"code": "0"})", R"({"code": 17})", R"({"code": -1})",
                             R"({"code": 3, "message": 5})", R"({"code": 3, "message": "", "details": []})",
                             R"({"code": 3, "message": "", "details": {"violations": {}}})",
                             R"({"code": 3, "message": "", "details": {"violations": [1]}})",
                             R"({"code": 3, "message": "", "details": {"retry_delay_ms": -1}})"}) {
        CAPTURE(text);
        const auto status = wire::status_thrown_by([&] { status_from_json(json::parse(text)); });
        REQUIRE(status);
        CHECK(status->code == StatusCode::unknown);
    }
}

TEST_CASE("An invalid field is named in message and violations", "[status]") {
    const StatusError error = invalid_field("gap.array", "is empty", reason::array_invalid);

    CHECK(std::string(error.what()) == "gap.array is empty");
    CHECK(error.status().code == StatusCode::invalid_argument);
    CHECK(error.status().reason == "ARRAY_INVALID");
    REQUIRE(error.status().violations.size() == 1);
    CHECK(error.status().violations[0].field == "gap.array");
    CHECK(error.status().violations[0].description == "is empty");
}
