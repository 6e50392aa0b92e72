#include <catch2/catch_test_macros.hpp>

#include "engine/ics/cache/least_recently_used.hpp"

using contactd::engine::LeastRecentlyUsed;

namespace {

bool any(int) {
    return true;
}

}  // namespace

TEST_CASE("A value is found by its key and by what it serves") {
    LeastRecentlyUsed<int> cache(100);
    cache.insert("a", 3, 1, any);

    CHECK(cache.find("a", any) == 3);
    CHECK_FALSE(cache.find("b", any));
    CHECK_FALSE(cache.find("a", [](int value) { return value > 3; }));
}

TEST_CASE("A value takes the place of those under its key that it replaces") {
    LeastRecentlyUsed<int> cache(100);
    cache.insert("a", 1, 10, any);
    cache.insert("a", 5, 10, [](int held) { return held > 1; });
    cache.insert("b", 2, 10, any);
    cache.insert("a", 4, 10, [](int held) { return held < 4; });

    CHECK(cache.usage().entries == 3);
    CHECK(cache.usage().bytes == 30);
    CHECK_FALSE(cache.find("a", [](int held) { return held == 1; }));
    CHECK(cache.find("a", [](int held) { return held == 5; }));
    CHECK(cache.find("b", any) == 2);
}

TEST_CASE("To find a value is to use it") {
    LeastRecentlyUsed<int> cache(20);
    cache.insert("a", 1, 10, any);
    cache.insert("b", 2, 10, any);
    cache.find("a", any);
    cache.insert("c", 3, 10, any);

    CHECK(cache.find("a", any));
    CHECK_FALSE(cache.find("b", any));
}

TEST_CASE("What is removed gives its bytes back") {
    LeastRecentlyUsed<int> cache(20);
    cache.insert("a", 1, 10, any);
    cache.insert("b", 2, 10, any);
    cache.remove("a");

    CHECK_FALSE(cache.find("a", any));
    CHECK(cache.usage().bytes == 10);
    CHECK(cache.usage().budget_bytes == 20);
}
