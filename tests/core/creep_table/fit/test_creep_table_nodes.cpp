#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

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

std::vector<double> forces_at_nodes(const CreepTablePlan& of) {
    std::vector<double> forces;
    for (const double nu : of.nu)
        for (int ratio = 0; ratio <= of.cells[0]; ++ratio)
            for (int angle = 0; angle <= of.cells[1]; ++angle) {
                const std::vector<double> w = creep_table_creepages(of, nu, ratio, angle);
                for (std::size_t k = 0; k < w.size(); k += 3) {
                    const auto found =
                        creep_table::blended_forces(creep_table_ratio(of, ratio), nu, {w[k], w[k + 1], w[k + 2]});
                    forces.insert(forces.end(), found.begin(), found.end());
                }
            }
    return forces;
}

}  // namespace

TEST_CASE("a table made from its nodes holds the forces there", "[creep_table]") {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "made.creep";
    write_creep_table(path, plan, forces_at_nodes(plan), "{\"made\": true}");
    const double nu = GENERATE(0.2, 0.3);
    const CreepTable table(path, nu);
    CHECK(table.description().starts_with("{\"made\": true}"));
    const double ratio = creep_table_ratio(plan, 1), a = std::sqrt(ratio);
    CHECK_THAT(ratio, WithinRel(0.5 * std::sqrt(2.0), 1e-12));
    const std::vector<double> w = creep_table_creepages(plan, nu, 1, GENERATE(0, 3, 8));
    REQUIRE(w.size() == 5 * 5 * 3);
    for (std::size_t k = 0; k < w.size(); k += 3) {
        const auto expected = creep_table::blended_forces(ratio, nu, {w[k], w[k + 1], w[k + 2]});
        const CreepForces found = table.forces({a, 1 / a, 1, 1, 1}, {w[k], w[k + 1], w[k + 2]});
        for (int i = 0; i < 3; ++i) CHECK_THAT(found.forces[i], WithinAbs(-expected[i], 5e-5));
    }
}

TEST_CASE("a plan that no table has is refused", "[creep_table]") {
    CreepTablePlan bad = plan;
    bad.cells[2] = 3;
    CHECK_THROWS_AS(creep_table_creepages(bad, 0.2, 0, 0), InvalidArgument);
    bad = plan;
    bad.ratios = {2, 0.5};
    CHECK_THROWS_AS(creep_table_creepages(bad, 0.2, 0, 0), InvalidArgument);
    CHECK_THROWS_AS(creep_table_creepages(plan, 0.2, 5, 0), InvalidArgument);
    CHECK_THROWS_AS(creep_table_creepages(plan, 0.2, 0, -1), InvalidArgument);
    CHECK_THROWS_AS(write_creep_table("none", plan, std::vector<double>(7), "{}"), InvalidArgument);
}
