// Tables of creep forces, which are written by core.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string>
#include <vector>

#include "contactd.h"
#include "contactd/creep_table.hpp"
#include "core/creep_table/blended_forces.hpp"
#include "creep_table/file/table_file.hpp"
#include "support/temporary_folder.hpp"

using Catch::Matchers::WithinRel;

namespace {

std::size_t allocations = 0;

struct Opened {
    contactd::TemporaryFolder folder;
    std::filesystem::path path = folder.path() / "table.creep";
    contactd_creep_table* table = nullptr;

    Opened() {
        using namespace contactd::creep_table;
        const BlendedTable& made = blended_table();
        const std::vector<float> bounds{0.001f, 0.002f};
        CreepFile file;
        file.grid = made.grid;
        file.nu = {made.nu};
        file.curve_cells = made.curve_axis.cells;
        file.curves = made.curves;
        file.coefficients = made.coefficients;
        file.bound_cells = {1, 1, 1, 1};
        file.bounds = bounds;
        file.description = "{\"seed\": 7}";
        write_creep_file(path, file);
        REQUIRE(contactd_creep_table_open(path.string().c_str(), 0.28, &table) == CONTACTD_OK);
    }
    ~Opened() { contactd_creep_table_close(table); }
};

constexpr double creepages[] = {1e-3, -2e-3, 3e-4};

}  // namespace

// Not inlined, because GCC takes a free() beside a new for a mistake.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* const memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

TEST_CASE("A table in C has the forces of the table in C++", "[c]") {
    const Opened opened;
    const contactd::CreepTable same(opened.path, 0.28);
    const contactd::CreepForces expected = same.forces({6, 5, 80000, 0.3, 1e5}, {1e-3, -2e-3, 3e-4});
    double forces[3], jacobian[9], bounds[2];
    REQUIRE(contactd_creep_table_forces(opened.table, 6, 5, 80000, 0.3, 1e5, creepages, forces, jacobian, bounds) ==
            CONTACTD_OK);
    for (int i = 0; i < 3; ++i) {
        CHECK(forces[i] == expected.forces[i]);
        for (int j = 0; j < 3; ++j) CHECK(jacobian[3 * i + j] == expected.by_creepage[i][j]);
    }
    CHECK_THAT(bounds[0], WithinRel(30.0, 1e-6));
    CHECK(bounds[1] == expected.moment_bound);
    CHECK(forces[0] < 0);  // against the creepage
}

TEST_CASE("Several contacts have the forces of each", "[c]") {
    const Opened opened;
    const double contacts[] = {6, 5, 80000, 0.3, 1e5, 5, 6, 80000, 0.3, 1e5};
    const double both[] = {1e-3, -2e-3, 3e-4, 0, 1e-3, 0};
    double forces[6], jacobians[18], one[3];
    REQUIRE(contactd_creep_table_many(opened.table, 2, contacts, both, forces, jacobians, nullptr) == CONTACTD_OK);
    for (int row = 0; row < 2; ++row) {
        const double* const c = contacts + 5 * row;
        REQUIRE(contactd_creep_table_forces(opened.table, c[0], c[1], c[2], c[3], c[4], both + 3 * row, one, nullptr,
                                            nullptr) == CONTACTD_OK);
        for (int i = 0; i < 3; ++i) CHECK(forces[3 * row + i] == one[i]);
    }
    CHECK(jacobians[9] < 0);
    CHECK(contactd_creep_table_many(opened.table, 0, nullptr, nullptr, nullptr, nullptr, nullptr) == CONTACTD_OK);
}

TEST_CASE("Evaluation allocates nothing", "[c]") {
    const Opened opened;
    double forces[3], jacobian[9], bounds[2];
    const std::size_t before = allocations;
    std::int32_t code = CONTACTD_OK;
    for (int n = 0; n < 100; ++n)
        code |=
            contactd_creep_table_forces(opened.table, 6, 5, 80000, 0.3, 1e5 + n, creepages, forces, jacobian, bounds);
    const std::size_t after = allocations;
    CHECK(code == CONTACTD_OK);
    CHECK(after == before);
}

TEST_CASE("A table reports what it holds", "[c]") {
    const Opened opened;
    double nu = 0, ratios[2];
    char text[8] = "", none = 'x';
    REQUIRE(contactd_creep_table_info(opened.table, &nu, ratios, text, 8) == CONTACTD_OK);
    CHECK(nu == 0.28);
    CHECK_THAT(ratios[0], WithinRel(0.5, 1e-12));
    CHECK_THAT(ratios[1], WithinRel(3.0, 1e-12));
    CHECK(std::string(text) == "{\"seed\"");
    CHECK(contactd_creep_table_info(opened.table, &nu, ratios, &none, 0) == CONTACTD_OK);
    CHECK(none == 'x');
}

TEST_CASE("What a table does not hold is refused", "[c]") {
    const Opened opened;
    double forces[3];
    const auto refused = [&](double a, double Fn, const double* creep, const std::string& field) {
        CHECK(contactd_creep_table_forces(opened.table, a, 5, 80000, 0.3, Fn, creep, forces, nullptr, nullptr) ==
              CONTACTD_INVALID_ARGUMENT);
        CHECK(contactd_last_field(opened.table) == field);
    };
    refused(20, 1e5, creepages, "a");
    refused(6, -1, creepages, "Fn");
    refused(6, 1e5, nullptr, "creepages");
    const double infinite[] = {0, HUGE_VAL, 0};
    refused(6, 1e5, infinite, "creepages");
    const double contacts[] = {6, 5, 80000, 0.3, 1e5, 6, 5, 80000, 0.3, 0};
    const double both[] = {0, 0, 0, 0, 0, 0};
    double many[6];
    CHECK(contactd_creep_table_many(opened.table, 2, contacts, both, many, nullptr, nullptr) ==
          CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_last_field(opened.table) == std::string("contacts[1].Fn"));
    contactd_creep_table* other = opened.table;
    CHECK(contactd_creep_table_open(opened.path.string().c_str(), 0.3, &other) == CONTACTD_INVALID_ARGUMENT);
    CHECK(other == nullptr);
}

TEST_CASE("Files that are not tables are refused by name", "[c]") {
    const Opened opened;
    contactd_creep_table* table = nullptr;
    const std::string missing = (opened.folder.path() / "none.creep").string();
    CHECK(contactd_creep_table_open(missing.c_str(), 0.28, &table) == CONTACTD_NOT_FOUND);
    CHECK(std::string(contactd_last_error(nullptr)).find("none.creep") != std::string::npos);
    const std::filesystem::path foreign = opened.folder.path() / "foreign.creep";
    std::ofstream(foreign) << "not a table";
    CHECK(contactd_creep_table_open(foreign.string().c_str(), 0.28, &table) == CONTACTD_DATA_LOSS);
    CHECK(std::string(contactd_last_error(nullptr)).starts_with("foreign.creep"));
    CHECK(table == nullptr);
}

TEST_CASE("A closed table is refused, and its place is used again", "[c]") {
    contactd_creep_table* closed = nullptr;
    {
        const Opened opened;
        closed = opened.table;
    }
    const Opened again;
    CHECK(again.table != closed);
    double forces[3];
    CHECK(contactd_creep_table_forces(closed, 6, 5, 80000, 0.3, 1e5, creepages, forces, nullptr, nullptr) ==
          CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_creep_table_close(closed) == CONTACTD_INVALID_ARGUMENT);
    CHECK(contactd_creep_table_forces(again.table, 6, 5, 80000, 0.3, 1e5, creepages, forces, nullptr, nullptr) ==
          CONTACTD_OK);
}
