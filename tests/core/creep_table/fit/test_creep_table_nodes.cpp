#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "contactd/creep_table.hpp"
#include "contactd/creep_table_nodes.hpp"
#include "contactd/error.hpp"
#include "creep_table/blended_forces.hpp"
#include "support/temporary_folder.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const CreepTablePlan plan{{0.5, 2}, {4, 8, 4, 6}, {0.2, 0.3}};
const CreepTablePlan long_contacts{{1, 8}, {6, 8, 4, 8}, {0.3}};

/// Adds a narrow bump at the apex to invented forces.
creep_table::Triple forces_of(double ratio, double nu, const creep_table::Triple& w) {
    creep_table::Triple forces = creep_table::blended_forces(ratio, nu, w);
    const creep_table::Triple scale = creep_table::full_slip(ratio, nu);
    const double distance = std::hypot(w[0] / scale[0], w[1] / scale[1], w[2] / scale[2] - 1);
    forces[1] += (ratio > 2 ? 0.1 * std::pow(std::log(ratio / 2), 2) : 0) * std::exp(-30 * distance * distance);
    return forces;
}

std::vector<double> forces_at_nodes(const CreepTablePlan& of) {
    std::vector<double> forces;
    for (const double nu : of.nu)
        for (int row = 0; row < static_cast<int>(creep_table_rows(of).size()); ++row) {
            const auto [ratio, w] = creep_table_row(of, nu, row);
            for (std::size_t k = 0; k < w.size(); k += 3) {
                const auto found = forces_of(ratio, nu, {w[k], w[k + 1], w[k + 2]});
                forces.insert(forces.end(), found.begin(), found.end());
            }
        }
    return forces;
}

struct Made {
    TemporaryFolder folder;
    std::filesystem::path path = folder.path() / "made.creep";

    explicit Made(const CreepTablePlan& of) { write_creep_table(path, of, forces_at_nodes(of), "{\"made\": true}"); }
};

void check_row(const CreepTable& table, const CreepTablePlan& of, int row) {
    const auto [ratio, w] = creep_table_row(of, table.nu(), row);
    const double a = std::sqrt(ratio);
    REQUIRE(w.size() == 3 * static_cast<std::size_t>(creep_table_rows(of)[static_cast<std::size_t>(row)]));
    for (std::size_t k = 0; k < w.size(); k += 3) {
        const auto expected = forces_of(ratio, table.nu(), {w[k], w[k + 1], w[k + 2]});
        const CreepForces found = table.forces({a, 1 / a, 1, 1, 1}, {w[k], w[k + 1], w[k + 2]});
        for (int i = 0; i < 3; ++i) CHECK_THAT(found.forces[i], WithinAbs(-expected[i], 5e-5));
    }
}

}  // namespace

TEST_CASE("a table made from its nodes holds the forces there", "[creep_table]") {
    const Made made(plan);
    const CreepTable table(made.path, GENERATE(0.2, 0.3));
    CHECK(table.description().starts_with("{\"made\": true}"));
    CHECK_THAT(creep_table_row(plan, 0.2, 9).a_over_b, WithinRel(0.5 * std::sqrt(2.0), 1e-12));
    check_row(table, plan, 9 + GENERATE(0, 3, 8));
}

TEST_CASE("a table of contacts longer than wide has a finer box at the apex", "[creep_table]") {
    CHECK(creep_table_rows(plan).size() == 5 * 9);
    const int of_table = 7 * 9, rows = static_cast<int>(creep_table_rows(long_contacts).size());
    CHECK(rows == of_table + 4 * 7);  // a/b of 2 is a node, where the box vanishes
    const Made made(long_contacts);
    check_row(CreepTable(made.path), long_contacts, of_table + GENERATE(0, 7 + 3, 3 * 7 + 6));
}

TEST_CASE("creepages at the points of a table are those of its nodes", "[creep_table]") {
    const double pi = std::numbers::pi;
    const std::vector<double> points{std::log(0.5), pi / 8, 0, 1.0 / 3, std::log(0.5), pi / 8, 0, 2.0 / 3};
    const std::vector<double> row = creep_table_row(plan, 0.2, 1).creepages;
    const std::vector<double> found = creep_table_creepages(plan, 0.2, points);
    REQUIRE(found.size() == 6);
    for (std::size_t k = 0; k < 6; ++k) CHECK_THAT(found[k], WithinRel(row[k], 1e-12));
}

TEST_CASE("certified bounds are those of the cells of a state", "[creep_table]") {
    const Made made(long_contacts);
    const CreepForces before = CreepTable(made.path).forces({2, 1, 1, 1, 1}, {0.1, 0.2, 0.3});
    const std::vector<float> bounds{0.25f, 0.5f, 0.125f, 2};
    certify_creep_table(made.path, {1, 1, 1, 2}, bounds, "{\"checked\": true}");
    const CreepTable table(made.path);
    CHECK(table.description().starts_with("{\"checked\": true}"));
    const CreepForces small = table.forces({4, 1, 1, 1, 0.5}, {0.01, 0, 0}),
                      large = table.forces({4, 1, 1, 1, 0.5}, {10, 0, 0});
    CHECK(small.force_bound == 0.125);
    CHECK(small.moment_bound == 0.5);  // c is 2
    CHECK(large.force_bound == 0.0625);
    CHECK(table.forces({2, 1, 1, 1, 1}, {0.1, 0.2, 0.3}).forces == before.forces);
    CHECK_THROWS_AS(certify_creep_table(made.path, {2, 2, 2, 2}, bounds, "{}"), InvalidArgument);
    CHECK(CreepTable(made.path).description().starts_with("{\"checked\": true}"));
}

TEST_CASE("a plan that no table has is refused", "[creep_table]") {
    CreepTablePlan bad = plan;
    bad.cells[2] = 3;
    CHECK_THROWS_AS(creep_table_row(bad, 0.2, 0), InvalidArgument);
    bad.cells[2] = 513;
    CHECK_THROWS_AS(creep_table_rows(bad), InvalidArgument);
    bad = plan;
    bad.ratios = {2, 0.5};
    CHECK_THROWS_AS(creep_table_creepages(bad, 0.2, {}), InvalidArgument);
    CHECK_THROWS_AS(creep_table_row(plan, 0.2, 45), InvalidArgument);
    CHECK_THROWS_AS(creep_table_row(plan, 0.2, -1), InvalidArgument);
    CHECK_THROWS_AS(write_creep_table("none", plan, std::vector<double>(7), "{}"), InvalidArgument);
}
