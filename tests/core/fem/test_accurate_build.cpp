// Tests tables to a requested accuracy, and families over Poisson's ratio.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <numbers>

#include "contactd/error.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "contactd/half_space.hpp"
#include "contactd/ic_family.hpp"
#include "fem_specs.hpp"

using namespace contactd;

namespace {

IcSpec accurate_spec(double accuracy, double nu, double dy, int n) {
    IcSpec spec;
    spec.material = {1, nu};
    spec.dx = 1;
    spec.dy = dy;
    spec.nx = spec.ny = n;
    spec.source = IcSource::fem;
    spec.accuracy = accuracy;
    return spec;
}

IcRecord build(const IcSpec& spec) {
    Observer observer;
    return fem::build_ic_table(spec, observer);
}

/// Returns the largest difference in the measures of IcSpec::accuracy.
double difference(const IcSpec& spec, const IcTable& table, const IcTable& other) {
    IcEvidence evidence;
    compare_tables(spec, table, other, evidence);
    return std::max({evidence.errors.xx->largest, evidence.errors.yy->largest, evidence.errors.zz->largest,
                     *evidence.errors.scaled_xy, *evidence.errors.scaled_xz});
}

IcTable closed_form(IcSpec spec) {
    spec.source = IcSource::analytic;
    spec.accuracy = 0;
    return half_space_table(spec);
}

}  // namespace

TEST_CASE("The accuracy asked for is met on a half-space", "[fem][accuracy]") {
    const double accuracy = GENERATE(1e-2, 1e-3);
    const double nu = GENERATE(0.0, 0.3, 0.35, 0.49);
    const double dy = GENERATE(1.0, 0.25);
    IcSpec spec = accurate_spec(accuracy, nu, dy, 12);
    spec.load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    CAPTURE(accuracy, nu, dy, name_of(spec.load_shape));
    const IcRecord record = build(spec);
    const double error = difference(spec, record.table(), closed_form(spec));
    CHECK(error <= accuracy);
    CHECK(record.evidence.mesh.has_value());
    CHECK(record.evidence.warnings.empty());
    CHECK_FALSE(record.evidence.errors_estimated);
}

// Slow: it builds tables of accuracy 1e-4.
TEST_CASE("Four digits are reached", "[fem][accuracy][slow]") {
    IcSpec spec = accurate_spec(1e-4, 0.28, 1, 12);
    spec.load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    CHECK(difference(spec, build(spec).table(), closed_form(spec)) <= 1e-4);
}

TEST_CASE("A larger extent changes the coefficients by less than the accuracy's tenth", "[fem][accuracy]") {
    const IcSpec small = accurate_spec(1e-3, 0.28, 1, 8), large = accurate_spec(1e-3, 0.28, 1, 24);
    CHECK(difference(small, cropped(build(large).table(), 8, 8), build(small).table()) < 1e-4);
}

// Slow: it compares each table with graded finite elements of the whole displacement.
TEST_CASE("The accuracy asked for is met by a block", "[fem][accuracy][slow]") {
    IcSpec spec = accurate_spec(1e-2, GENERATE(0.28, 0.42), 1, 8);
    spec.body = BodyShape::block;
    spec.fem.L_over_h = 16;
    const IcRecord record = build(spec);
    CHECK(record.evidence.errors_estimated);

    // Uses the general method: finite elements of the whole displacement, graded towards the load.
    IcSpec general = spec;
    general.accuracy = 0;
    general.fem.far_boundary = FarBoundary::clamped;
    general.fem.order = 5;
    general.fem.l_over_h = 0.5;
    general.fem.f = 1.5;
    general.fem.t1_over_hs = 1;
    const IcRecord reference = build(general);
    CHECK(difference(spec, record.table(), reference.table()) <= 1e-2);
    CHECK(difference(spec, closed_form(accurate_spec(1e-2, spec.material.nu, 1, 8)), reference.table()) > 1e-2);
}

// Slow: a table to a thousandth.
TEST_CASE("The error that a block's table states is no less than its difference to a finer table",
          "[fem][accuracy][slow]") {
    // Uses points near the clamped edges of a nearly incompressible block, where finite elements converge most slowly.
    IcSpec spec = accurate_spec(1e-2, 0.49, 1, 12);
    spec.body = BodyShape::block;
    spec.fem.L_over_h = 13;
    IcSpec finer_spec = spec;
    finer_spec.accuracy = 1e-3;
    const IcRecord record = build(spec), finer = build(finer_spec);
    IcEvidence difference_to_finer;
    compare_tables(spec, record.table(), finer.table(), difference_to_finer);
    CHECK(difference_to_finer.errors.zz->largest <= record.evidence.errors.zz->largest + 1e-3);
    CHECK(difference_to_finer.errors.xx->largest <= record.evidence.errors.xx->largest + 1e-3);
    CHECK(record.evidence.errors.zz->largest > finer.evidence.errors.zz->largest);
}

TEST_CASE("A family differs from a direct computation by less than a tenth of the accuracy", "[fem][family]") {
    IcSpec family = accurate_spec(1e-2, 0, 1, 6);
    family.any_nu = true;
    const IcRecord record = build(family);
    REQUIRE(std::get<IcFamily>(record.tables).tables.size() == record.evidence.family_nu.size());
    CHECK(record.evidence.interpolation_error < 1e-3);
    for (const double nu : {0.05, 0.17, 0.3, 0.47, 0.49}) {
        const IcSpec one = accurate_spec(1e-2, nu, 1, 6);
        CAPTURE(nu);
        CHECK(difference(one, table_for(record, one), build(one).table()) < 1e-3);
    }
    // A single table needs only a coarser mesh here than the family, which has one mesh up to 0.49.
    for (const double nu : {0.33, 0.41}) {
        const IcSpec between = accurate_spec(1e-2, nu, 1, 6);
        CHECK(difference(between, table_for(record, between), closed_form(between)) < 5e-3);
    }
}

TEST_CASE("Poisson's ratios beyond 0.3 cost no more as long as the mesh does", "[fem][accuracy]") {
    const double accuracy = GENERATE(1e-2, 1e-3);
    CHECK(build(accurate_spec(accuracy, 0.31, 1, 12)).evidence.dofs ==
          build(accurate_spec(accuracy, 0.3, 1, 12)).evidence.dofs);
}

TEST_CASE("A family on a given mesh is interpolated as well as the mesh deserves", "[fem][family]") {
    IcSpec family = coarse_spec(6, 6, 1, 1);
    family.material.G = 1;
    family.fem.far_boundary = FarBoundary::half_space;
    family.fem.solver = Solver::automatic;
    family.any_nu = true;
    const IcRecord record = build(family);
    CHECK(record.evidence.family_nu.size() < 34);
    // Quadratic elements lock here, and interpolation is most difficult.
    IcSpec one = family;
    one.any_nu = false;
    one.material.nu = 0.47;
    const IcRecord direct = build(one);
    const double error =
        std::max(std::abs(direct.evidence.errors.xx->origin), std::abs(direct.evidence.errors.zz->origin));
    CHECK(difference(one, table_for(record, one), direct.table()) < error / 5);
}

TEST_CASE("A table that differs from the closed form by more than 1 % warns", "[fem][warnings]") {
    IcSpec spec = coarse_spec(6, 6, 1, 1);
    spec.fem = FemSpec{};
    spec.fem.f = 1.5;
    spec.fem.L_over_h = 40;
    spec.material.nu = 0.45;
    CHECK(build(spec).evidence.warnings.empty());
    spec.material.nu = 0.499;
    const IcEvidence evidence = build(spec).evidence;
    REQUIRE(evidence.warnings.size() == 1);
    CHECK(evidence.warnings[0].find("differ from the closed form by up to 6.") != std::string::npos);
    CHECK(evidence.warnings[0].find("lock") != std::string::npos);

    spec.body = BodyShape::block;
    spec.fem.far_boundary = FarBoundary::clamped;
    REQUIRE(build(spec).evidence.warnings.size() == 1);
    CHECK(build(spec).evidence.warnings[0].find("nu is 0.499") != std::string::npos);
}
