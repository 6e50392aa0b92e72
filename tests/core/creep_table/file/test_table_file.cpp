#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <fstream>
#include <iterator>

#include "contactd/creep_table.hpp"
#include "contactd/ic_store.hpp"
#include "creep_table/written_table.hpp"

using namespace contactd;
using namespace contactd::creep_table;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace fs = std::filesystem;

namespace {

using Bytes = std::vector<unsigned char>;

Bytes content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

fs::path write(const TemporaryFolder& folder, const Bytes& bytes) {
    const fs::path path = folder.path() / "changed.creep";
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
    return path;
}

}  // namespace

TEST_CASE("damaged files are refused by name", "[creep_table]") {
    const Written file;
    const Bytes whole = content(file.path);
    Bytes bytes = whole;
    SECTION("a changed bit") {
        bytes[GENERATE_COPY(std::size_t{300}, std::size_t{520}, std::size_t{5000}, whole.size() / 2,
                            whole.size() - 1)] ^= 4;
    }
    SECTION("a missing or an added end") {
        bytes.resize(GENERATE_COPY(std::size_t{0}, std::size_t{20}, std::size_t{100}, std::size_t{512},
                                   std::size_t{600}, whole.size() - 1, whole.size() + 1));
    }
    SECTION("a size without bounds") {
        const int field = GENERATE(range(5, 21));  // file_size to bound_cells
        for (int k = 0; k < 8; ++k) bytes[8 * field + k] = 0xff;
    }
    CHECK_THROWS_MATCHES(CreepTable(write(file.folder, bytes), 0.28), DamagedTable,
                         MessageMatches(ContainsSubstring("changed.creep")));
}

TEST_CASE("foreign, newer and missing files are refused by name", "[creep_table]") {
    const Written file;
    Bytes bytes = content(file.path);
    bytes[32] = 2;
    CHECK_THROWS_MATCHES(CreepTable(write(file.folder, bytes), 0.28), NewerFormat,
                         MessageMatches(ContainsSubstring("changed.creep was written by a newer version")));
    bytes[0] = 'X';
    CHECK_THROWS_MATCHES(CreepTable(write(file.folder, bytes), 0.28), DamagedTable,
                         MessageMatches(ContainsSubstring("changed.creep is not a creep-force table")));
    CHECK_THROWS_MATCHES(CreepTable(file.folder.path() / "none.creep", 0.28), StoreError,
                         MessageMatches(ContainsSubstring("none.creep")));
    CHECK_THROWS_AS(CreepTable(file.folder.path(), 0.28), StoreError);
}

TEST_CASE("parts that do not fit together are not written", "[creep_table]") {
    const Written file;
    CreepFile parts = two_ratios().file;
    SECTION("an array of another size") {
        parts.coefficients = parts.coefficients.first(100);
    }
    SECTION("no Poisson's ratio") {
        parts.nu.clear();
    }
    SECTION("Poisson's ratios in another order") {
        parts.nu = {0.4, 0.28};
    }
    SECTION("too many Poisson's ratios") {
        parts.nu.assign(9, 0.1);
    }
    CHECK_THROWS_AS(write_creep_file(file.path, parts), InvalidArgument);
    CHECK(content(file.path).size() > 1000);
}
