// Tests displacements of the half-space on the far faces, the bilinear load, and the solvers.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contactd/error.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/half_space.hpp"
#include "fem_specs.hpp"

using namespace contactd;
using Catch::Matchers::WithinRel;

namespace {

IcRecord build(const IcSpec& spec) {
    Observer observer;
    return fem::build_ic_table(spec, observer);
}

IcSpec open_spec(double L_over_h) {
    IcSpec spec = paper_spec("paper-test3", 0.8 * L_over_h);
    spec.fem.far_boundary = FarBoundary::half_space;
    spec.fem.solver = Solver::automatic;
    return spec;
}

double largest_difference(const IcTable& a, const IcTable& b) {
    double difference = 0, largest = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        difference = std::max(difference, std::abs(a.values[i] - b.values[i]));
        largest = std::max(largest, std::abs(a.values[i]));
    }
    return difference / largest;
}

}  // namespace

TEST_CASE("With the half-space's displacements on the far faces the error does not depend on L", "[fem][far]") {
    const IcEvidence near = build(open_spec(10)).evidence, far = build(open_spec(40)).evidence;
    for (const IcEvidence& evidence : {near, far}) {
        CHECK(evidence.errors.zz->largest <= 1e-3);
        CHECK(evidence.errors.xx->largest <= 1e-3);
    }
    CHECK(std::abs(near.errors.zz->origin - far.errors.zz->origin) < 1e-4);
}

TEST_CASE("The bilinear load has the reference errors", "[fem][far][verification]") {
    IcSpec spec = open_spec(80);
    spec.load_shape = LoadShape::bilinear;
    const IcRecord record = build(spec);
    CHECK_THAT(record.evidence.errors.zz->origin, WithinRel(-1.67e-3, 0.05));
    CHECK_THAT(record.evidence.errors.xx->origin, WithinRel(-2.42e-3, 0.05));
    CHECK_THAT(record.evidence.errors.zz->largest, WithinRel(1.7e-3, 0.05));
    CHECK_THAT(record.evidence.errors.xx->largest, WithinRel(2.4e-3, 0.05));

    double xy = 0;
    for (int l = 1; l < spec.ny; ++l)
        for (int k = 1; k < spec.nx; ++k) {
            const double exact = half_space_bilinear_coefficient(Axis::x, Axis::y, k, l, 1, 1, {1, 0.28});
            xy = std::max(xy, std::abs(record.table()(Axis::x, Axis::y, k, l) / exact - 1));
        }
    CHECK_THAT(xy, WithinRel(4.4e-3, 0.05));
}

TEST_CASE("Both solvers find the same coefficients", "[fem][solvers]") {
    IcSpec spec = coarse_spec(6, 5, 1, GENERATE(1.0, 0.6));
    spec.fem.order = GENERATE(1, 2, 3);
    spec.fem.far_boundary = GENERATE(FarBoundary::clamped, FarBoundary::half_space);
    spec.fem.tolerance = 1e-11;
    spec.fem.solver = Solver::direct;
    const IcRecord direct = build(spec);
    spec.fem.solver = Solver::amg_pcg;
    const IcRecord iterative = build(spec);
    CHECK(direct.evidence.solver == "direct");
    CHECK(iterative.evidence.solver == "amg_pcg");
    CHECK(largest_difference(direct.table(), iterative.table()) < 1e-9);
}

TEST_CASE("Stopping by the update reports it beside the true residual", "[fem][solvers]") {
    IcSpec spec = coarse_spec(4, 4, 1, 1);
    spec.fem.stopping_criterion = StoppingCriterion::update;
    spec.fem.tolerance = 1e-6;
    const IcRecord record = build(spec);
    REQUIRE(record.evidence.load_cases.size() == 2);
    for (const LoadCaseEvidence& load_case : record.evidence.load_cases) {
        REQUIRE(load_case.update.has_value());
        CHECK(*load_case.update <= 1e-6);
        CHECK(load_case.residual > 0);
    }
    spec.fem.max_iterations = 2;
    CHECK_THROWS_AS(build(spec), NotConverged);
}

TEST_CASE("A block on a given mesh has no closed form to be compared with", "[fem][block]") {
    IcSpec spec = coarse_spec(10, 10, 1, 1);
    spec.body = BodyShape::block;
    const IcRecord record = build(spec);
    CHECK_FALSE(record.evidence.errors.zz.has_value());
    CHECK_FALSE(record.evidence.errors.scaled_xy.has_value());
}
