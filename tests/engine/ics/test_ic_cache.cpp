#include <catch2/catch_test_macros.hpp>

#include "engine/ics/cache/ic_cache.hpp"

using namespace contactd;
using namespace contactd::engine;

namespace {

IcCache::Record record_of(int nx, int ny) {
    IcRecord record;
    record.tables = IcTable(nx, ny);
    return std::make_shared<const IcRecord>(std::move(record));
}

constexpr std::size_t bytes_of(int nx, int ny) {
    return 9u * static_cast<unsigned>(nx * ny) * sizeof(double);
}

}  // namespace

TEST_CASE("The cache gives a table that covers the extent") {
    IcCache cache(1 << 20);
    cache.insert("a", record_of(4, 3));

    CHECK(cache.find("a", 4, 3));
    CHECK(cache.find("a", 1, 1));
    CHECK_FALSE(cache.find("a", 5, 1));
    CHECK_FALSE(cache.find("b", 1, 1));
}

TEST_CASE("A larger table takes the place of the one it covers") {
    IcCache cache(1 << 20);
    cache.insert("a", record_of(4, 3));
    cache.insert("a", record_of(8, 8));

    CHECK(cache.usage().entries == 1);
    CHECK(cache.usage().bytes == bytes_of(8, 8));
}

TEST_CASE("The least recently used table goes when the budget is full") {
    IcCache cache(2 * bytes_of(4, 4));
    cache.insert("a", record_of(4, 4));
    cache.insert("b", record_of(4, 4));
    cache.find("a", 1, 1);
    cache.insert("c", record_of(4, 4));

    CHECK(cache.find("a", 1, 1));
    CHECK_FALSE(cache.find("b", 1, 1));
    CHECK(cache.find("c", 1, 1));
    CHECK(cache.usage().bytes <= cache.usage().budget_bytes);
}

TEST_CASE("A table larger than the budget is not cached and evicts nothing") {
    IcCache cache(bytes_of(4, 4));
    cache.insert("a", record_of(4, 4));
    cache.insert("b", record_of(5, 5));

    CHECK(cache.find("a", 4, 4));
    CHECK_FALSE(cache.find("b", 1, 1));
}

TEST_CASE("The tables of a family count") {
    const auto family_of = [](std::size_t size) {
        return std::make_shared<const IcRecord>(IcRecord{{}, IcFamily{std::vector<IcTable>(size, IcTable(4, 4))}, {}});
    };
    IcCache cache(4 * bytes_of(4, 4));

    cache.insert("a", family_of(4));
    CHECK(cache.usage().bytes == 4 * bytes_of(4, 4));

    cache.insert("b", family_of(5));
    CHECK_FALSE(cache.find("b", 1, 1));
}
