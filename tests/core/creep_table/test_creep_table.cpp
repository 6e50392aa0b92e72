#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <utility>

#include "contactd/creep_table.hpp"
#include "contactd/error.hpp"
#include "written_table.hpp"

using namespace contactd;
using namespace contactd::creep_table;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr CreepContact contact{6, 5, 80000, 0.3, 1e5};
constexpr std::array creepages{1e-3, -2e-3, 3e-4};

}  // namespace

TEST_CASE("a table that was written and mapped holds the same forces", "[creep_table]") {
    const Written file;
    const CreepTable table(file.path, 0.28);
    CHECK(table.description().starts_with("{\"recipe\": \"blended\"}"));
    CHECK_THAT(table.ratios()[1], WithinRel(3, 1e-12));
    CreepSpline spline = blended_table().spline();
    const double c = std::sqrt(30.0), unit = 80000 * 30 / 3e4;
    const Triple w{unit * creepages[0], unit * creepages[1], unit * c * creepages[2]};
    const Triple expected = evaluate(spline, std::log(1.2), w).forces;
    const CreepForces found = table.forces(contact, creepages);
    CHECK_THAT(found.forces[0], WithinRel(-3e4 * expected[0], 1e-12));
    CHECK_THAT(found.forces[1], WithinRel(-3e4 * expected[1], 1e-12));
    CHECK_THAT(found.forces[2], WithinRel(-3e4 * c * expected[2], 1e-12));
    CHECK_THAT(found.force_bound, WithinRel(3e4 * 0.001, 1e-6));
    CHECK_THAT(found.moment_bound, WithinRel(3e4 * c * 0.002, 1e-6));
}

TEST_CASE("derivatives by creepages and by the contact are those of the forces", "[creep_table]") {
    const Written file;
    const CreepTable table(file.path, GENERATE(0.28, 0.35));
    const CreepForces here = table.forces(contact, creepages);
    for (int j = 0; j < 8; ++j) {
        constexpr double share = 1e-3;
        const auto moved = [&](double factor) {
            CreepContact at = contact;
            std::array creep = creepages;
            double* const inputs[]{&creep[0], &creep[1], &creep[2], &at.a, &at.b, &at.G, &at.mu, &at.Fn};
            const double before = *inputs[j];
            *inputs[j] *= factor;
            return std::pair(table.forces(at, creep).forces, before * (factor - 1));
        };
        const auto [high, after] = moved(1 + share);
        const auto [low, before] = moved(1 - share);
        for (int i = 0; i < 3; ++i) {
            const double slope = (high[i] - low[i]) / (after - before);
            const double found = j < 3 ? here.by_creepage[i][j] : here.by_contact[i][j - 3];
            CAPTURE(i, j);
            CHECK_THAT(found * (after - before),
                       WithinAbs(slope * (after - before), 2e-3 * share * 3e4 * (i == 2 ? 5 : 1)));
        }
    }
}

TEST_CASE("a table of several Poisson's ratios is interpolated to one", "[creep_table]") {
    const Written file;
    const CreepTable middle(file.path, 0.34), first(file.path, 0.28);
    CHECK(middle.nu() == 0.34);
    // The arrays in the middle are 1.5 times the first, so forces are, at equal scaled creepages.
    const Triple one = full_slip(1, 0.28), other = full_slip(1, 0.34);
    constexpr CreepContact disc{1, 1, 1, 1, 1};
    const CreepForces here = first.forces(disc, {one[0], one[1], one[2]});
    const CreepForces there = middle.forces(disc, {other[0], other[1], other[2]});
    for (int i = 0; i < 3; ++i) CHECK_THAT(there.forces[i], WithinRel(1.5 * here.forces[i], 1e-4));
    CHECK_THROWS_MATCHES(CreepTable(file.path, 0.45), InvalidArgument,
                         MessageMatches(ContainsSubstring("nu is 0.45; this table holds 0.28 to 0.4")));
}

TEST_CASE("contacts outside of a table are refused", "[creep_table]") {
    const Written file;
    const CreepTable table(file.path, 0.28);
    CreepContact thin = contact, weightless = contact;
    thin.a = 16;
    weightless.Fn = 0;
    CHECK_THROWS_MATCHES(table.forces(thin, creepages), InvalidArgument,
                         MessageMatches(ContainsSubstring("a is 3.2 times b; the table holds a/b from 0.5 to 3")));
    CHECK_THROWS_MATCHES(table.forces(weightless, creepages), InvalidArgument,
                         MessageMatches(ContainsSubstring("Fn is 0; it must be positive")));
}
