// Tests wear of wheels on rails: the Manchester benchmark, rows in track coordinates, mirrored left wheels.
#include <cmath>
#include <iterator>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contactd/error.hpp"
#include "wear/wear_laws.hpp"
#include "wheel_rail/manchester.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Lists earlier results of the right wheel with elements of 0.2 mm: sums over elements, and the largest |t s|.
struct WornCase {
    double y, pressure_slip, usfd, largest;
};

WheelRailSetup worn_setup(Side side, WearEnergy energy) {
    WheelRailSetup setup = manchester_setup(side);
    setup.wear = WearRequest{energy, {usfd_law(), energy_law(6.75e-4), br_mild_law()}};
    return setup;
}

double sum_of_rows(const ContactWear& wear, double WearRow::* integral, double dy) {
    double sum = 0;
    for (const WearRow& row : wear.rows) sum += row.*integral * dy;
    return sum;
}

}  // namespace

TEST_CASE("Wheels of the Manchester benchmark wear as told for their positions") {
    const WornCase known = GENERATE(WornCase{2, 47.29, 75.20, 1.2}, WornCase{4, 94.29, 149.9, 2.0},
                                    WornCase{6, 160.5, 255.2, 5.7}, WornCase{8, 501.3, 377.8, 31});
    const WheelRailSetup setup = worn_setup(Side::right, WearEnergy::plain);
    const WheelRailSolution solution = solve(setup, manchester_state(manchester_at(Side::right, known.y)));
    REQUIRE(solution.patches.size() == 1);
    const ContactWear& wear = *solution.patches[0].solution.wear;
    CAPTURE(known.y, wear.laws[0].area, wear.largest_dissipation);
    CHECK_THAT(sum_of_rows(wear, &WearRow::pressure_slip, setup.dy), WithinRel(known.pressure_slip, 2e-4));
    constexpr double steel = 1e-12 / 7.85e-6;  // mm of 1 ug/(m mm^2) of 1 mm
    CHECK_THAT(wear.laws[0].area / steel, WithinRel(known.usfd, 5e-4));
    CHECK_THAT(wear.largest_dissipation, WithinRel(known.largest, 0.03));
    CHECK_THAT(wear.dissipation,
               WithinRel(*solution.frictional_power() / solution.patches[0].place.creepages.velocity, 1e-6));
}

TEST_CASE("Rows of a patch lie on its plane in track coordinates") {
    const WheelRailSetup setup = worn_setup(Side::right, WearEnergy::scaled);
    const WheelRailSolution solution = solve(setup, manchester_state(manchester_at(Side::right, 6)));
    const WheelRailPatch& patch = solution.patches.at(0);
    const ContactWear& wear = *patch.solution.wear;
    REQUIRE(wear.rows.size() > 2);
    for (std::size_t i = 0; i < wear.rows.size(); ++i) {
        const WearRow& row = wear.rows[i];
        CHECK(row.angle == patch.place.reference.angle);
        CHECK_THAT((row.z - patch.place.reference.z) * std::cos(row.angle),
                   WithinAbs((row.y - patch.place.reference.y) * std::sin(row.angle), 1e-9));
        if (i > 0) CHECK_THAT(std::hypot(row.y - wear.rows[i - 1].y, row.z - wear.rows[i - 1].z), WithinRel(0.2, 1e-9));
    }
    CHECK_THAT(sum_of_rows(wear, &WearRow::dissipation, setup.dy), WithinRel(wear.T_gamma_with_spin, 1e-12));
    const Creepages& creepages = patch.place.creepages;
    const Forces& forces = patch.solution.forces;
    CHECK_THAT(wear.T_gamma, WithinRel(std::abs(forces.Fx * creepages.xi + forces.Fy * creepages.eta), 1e-12));
    CHECK_THAT(wear.T_gamma_with_spin,
               WithinRel(-(forces.Fx * creepages.xi + forces.Fy * creepages.eta + forces.Mz * creepages.phi), 1e-12));
}

TEST_CASE("A left wheel wears as the right one that is its mirror image") {
    const WheelRailState right_state = manchester_state(manchester_at(Side::right, 6));
    WheelRailState left_state = right_state;
    left_state.position.y *= -1;
    left_state.position.roll *= -1;
    left_state.position.yaw *= -1;
    const WheelRailSolution right = solve(worn_setup(Side::right, WearEnergy::scaled), right_state);
    const WheelRailSolution left = solve(worn_setup(Side::left, WearEnergy::scaled), left_state);
    const ContactWear &r = *right.patches.at(0).solution.wear, &l = *left.patches.at(0).solution.wear;
    CHECK(l.T_gamma == r.T_gamma);
    CHECK(l.laws == r.laws);
    REQUIRE(l.rows.size() == r.rows.size());
    for (std::size_t i = 0; i < r.rows.size(); ++i) {
        WearRow mirrored = r.rows[r.rows.size() - 1 - i];
        mirrored.y = 0 - mirrored.y;
        mirrored.angle = 0 - mirrored.angle;
        CHECK(l.rows[i] == mirrored);
    }
}

TEST_CASE("Rows of a conformal contact have normals of their own") {
    WheelRailSetup setup = worn_setup(Side::right, WearEnergy::scaled);
    setup.conformal = Conformal::half_space;
    setup.rigid_slip = RigidSlipKind::surfaces;
    const WheelRailSolution solution = solve(setup, manchester_state(manchester_at(Side::right, 6)));
    const WheelRailPatch& patch = solution.patches.at(0);
    const ContactWear& wear = *patch.solution.wear;
    CHECK(std::abs(wear.rows.front().angle - wear.rows.back().angle) > 0.01);
    CHECK_THAT(wear.T_gamma_with_spin, WithinRel(90.0 / 2, 0.25));
    CHECK(wear.T_gamma > 0.7 * wear.T_gamma_with_spin);
    CHECK_THAT(wear.factor, WithinAbs(1, 0.05));
    CHECK_THAT(sum_of_rows(wear, &WearRow::dissipation, setup.dy), WithinRel(wear.T_gamma_with_spin, 1e-12));
}

TEST_CASE("Zones of a rail weigh rows by the angle of their plane") {
    WheelRailSetup setup = worn_setup(Side::right, WearEnergy::scaled);
    const WheelRailState state = manchester_state(manchester_at(Side::right, 8));
    const double all = solve(setup, state).patches.at(0).solution.wear->laws[1].area;
    for (WearLaw& law : setup.wear->laws) law.zones = {{-0.8, 0.1}, {-0.7, 1}};  // the gauge face is lubricated
    CHECK_THAT(solve(setup, state).patches.at(0).solution.wear->laws[1].area, WithinRel(0.1 * all, 1e-12));
}

TEST_CASE("Wheels wear as they roll steadily") {
    const WheelRailSetup setup = worn_setup(Side::right, WearEnergy::scaled);
    WheelRailState state = manchester_state(manchester_at(Side::right, 2));
    state.motion = WheelRailMotion::transient_rolling;
    try {
        solve(setup, state);
        FAIL("should have been refused");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "state.motion");
    }
}
