#include <catch2/catch_test_macros.hpp>
#include <string>

#include "access/rate_limit.hpp"

using contactd::server::RateLimit;
using namespace std::chrono_literals;

namespace {

const RateLimit::Clock::time_point start{};

}  // namespace

TEST_CASE("A burst is let through, then as many as come back") {
    RateLimit limit(2, 3);
    for (int n = 0; n < 3; ++n) CHECK(limit.take("alice", start) == 0ms);
    CHECK(limit.take("alice", start) == 500ms);
    CHECK(limit.take("alice", start + 400ms) == 100ms);
    CHECK(limit.take("alice", start + 500ms) == 0ms);
    CHECK(limit.take("alice", start + 500ms) == 500ms);
}

TEST_CASE("A long silence gives a burst and no more") {
    RateLimit limit(1000, 2);
    CHECK(limit.take("alice", start) == 0ms);
    for (int n = 0; n < 2; ++n) CHECK(limit.take("alice", start + 1h) == 0ms);
    CHECK(limit.take("alice", start + 1h) > 0ms);
}

TEST_CASE("Users do not share") {
    RateLimit limit(1, 1);
    CHECK(limit.take("alice", start) == 0ms);
    CHECK(limit.take("bob", start) == 0ms);
    CHECK(limit.take("alice", start) > 0ms);
}

TEST_CASE("No rate is no limit") {
    RateLimit limit(0, 1);
    for (int n = 0; n < 1000; ++n) CHECK(limit.take("alice", start) == 0ms);
}

TEST_CASE("Users that come in thousands are forgotten once they are idle, and those who are not are kept") {
    RateLimit limit(1, 1);
    CHECK(limit.take("alice", start + 59s) == 0ms);
    for (int n = 0; n < 5000; ++n) limit.take("address " + std::to_string(n), start);
    CHECK(limit.users() == 5001);
    CHECK(limit.take("bob", start + 59s) == 0ms);
    for (int n = 0; n < 5000; ++n) limit.take("other " + std::to_string(n), start + 59s);
    CHECK(limit.users() <= 5002 + 1);
    CHECK(limit.take("alice", start + 59s) > 0ms);
}
