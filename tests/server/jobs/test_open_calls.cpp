#include <catch2/catch_test_macros.hpp>

#include "jobs/open_calls.hpp"

using namespace contactd::server;
using contactd::proto::StatusError;

namespace {

const contactd::MessageLimits limits;

CallPtr call_of(const std::string& client, const std::string& id, int timeout_ms = 0) {
    contactd::proto::Request request;
    request.id = id;
    request.timeout_ms = timeout_ms;
    return std::make_shared<Call>(Route{client}, request, Call::Clock::now(), contactd::proto::Priority::normal, limits,
                                  [](const Answer&) {});
}

std::string refusal_of(OpenCalls& open, const std::string& client, std::size_t bytes) {
    try {
        open.admit({client}, bytes);
    } catch (const StatusError& error) {
        CHECK(error.status().reason == "QUEUE_FULL");
        CHECK(error.status().retry_delay_ms > 0);
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("Requests are bounded in number, by client and in bytes") {
    OpenCalls open({3, 2, 100});
    const auto first = open.admit({"a"}, 10);
    const auto second = open.admit({"a"}, 10);
    CHECK(refusal_of(open, "a", 10).find("max_queue_per_client") != std::string::npos);
    CHECK(refusal_of(open, "b", 81).find("max_queue_bytes") != std::string::npos);
    const auto third = open.admit({"b"}, 80);
    CHECK(refusal_of(open, "c", 1).find("max_queue)") != std::string::npos);
    CHECK(open.count() == 3);

    open.close(first.number);
    CHECK(open.count() == 2);
    CHECK(refusal_of(open, "a", 1).find("max_queue_bytes") != std::string::npos);  // still held by `first`
}

TEST_CASE("Requests of a user are counted over all clients, and given back") {
    OpenCalls open({9, 9, 100, 2});
    const auto first = open.admit({"a", false, "alice"}, 1);
    open.admit({"b", false, "alice"}, 1);
    CHECK_THROWS_AS(open.admit({"c", false, "alice"}, 1), StatusError);
    CHECK_NOTHROW(open.admit({"a", false, "bob"}, 1));
    open.close(first.number);
    CHECK_NOTHROW(open.admit({"c", false, "alice"}, 1));
    CHECK_THROWS_AS(open.admit({"d", false, "alice"}, 1), StatusError);
}

TEST_CASE("Bytes are given back when nobody holds them any more") {
    OpenCalls open({3, 3, 100});
    auto admission = open.admit({"a"}, 200);  // alone, so it is admitted
    CHECK(open.bytes() == 200);
    open.close(admission.number);
    CHECK(open.bytes() == 200);
    admission.bytes.reset();
    CHECK(open.bytes() == 0);
}

TEST_CASE("A request is found by its client and id until it is answered") {
    OpenCalls open({9, 9, 100});
    const auto call = call_of("a", "7f");
    const auto admission = open.admit({"a"}, 1);
    CHECK(open.has_unread("a"));
    CHECK(open.find("a", "7f").empty());
    CHECK(open.attach(admission.number, call));
    CHECK_FALSE(open.has_unread("a"));
    CHECK(open.find("a", "7f") == std::vector{call});
    CHECK(open.find("b", "7f").empty());
    CHECK(open.find("a", "80").empty());
    call->fail({});
    CHECK(open.find("a", "7f").empty());
}

TEST_CASE("The requests of one client are found, read or not") {
    OpenCalls open({9, 9, 100});
    const auto call = call_of("a", "1");
    const auto read = open.admit({"a"}, 1), unread = open.admit({"a"}, 1);
    open.admit({"b"}, 1);
    open.attach(read.number, call);

    const auto found = open.of("a");
    REQUIRE(found.size() == 2);
    CHECK(found[0].first == read.number);
    CHECK(found[0].second.call == call);
    CHECK(found[1].first == unread.number);
    CHECK_FALSE(found[1].second.call);
    CHECK(open.of("c").empty());
}

TEST_CASE("The next deadline is that of a request without an answer") {
    OpenCalls open({9, 9, 100});
    const auto soon = call_of("a", "1", 1000), late = call_of("a", "2", 2000), never = call_of("a", "3");
    for (const auto& call : {late, never, soon}) open.attach(open.admit({"a"}, 0).number, call);
    CHECK(open.next_deadline() == soon->deadline());
    CHECK(open.overdue(soon->deadline()) == std::vector{soon});
    CHECK(open.overdue(late->deadline()).size() == 2);
    soon->fail({});
    CHECK(open.next_deadline() == late->deadline());
}

TEST_CASE("What was closed cannot be attached") {
    OpenCalls open({9, 9, 100});
    const auto admission = open.admit({"a"}, 1);
    const auto taken = open.take_all();
    REQUIRE(taken.size() == 1);
    CHECK(taken[0].route.identity == "a");
    CHECK_FALSE(taken[0].call);
    CHECK_FALSE(open.attach(admission.number, call_of("a", "1")));
    open.close(admission.number);
    CHECK(open.count() == 0);
}
