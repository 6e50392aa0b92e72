#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <random>

#include "build/adaptive_build.hpp"
#include "build/error_estimate.hpp"
#include "contactd/error.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "fem_specs.hpp"

using namespace contactd;
using namespace contactd::fem;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

IcSpec adaptive_spec(long long max_dofs, double dx = 1, double dy = 1) {
    IcSpec spec = coarse_spec(10, 10, dx, dy);
    spec.fem = FemSpec{};
    spec.fem.mesh = MeshKind::adaptive;
    spec.fem.max_dofs = max_dofs;
    spec.fem.L_over_h = 12;
    return spec;
}

IcRecord build(const IcSpec& spec) {
    Observer observer;
    return build_ic_table(spec, observer);
}

/// Divides one element at the load, and then some of its parts and of elements farther out, so that there are hanging
/// nodes on inner faces, on the surface, on the planes of symmetry and on the far faces.
RefinedBlock twice_refined(const IcSpec& spec) {
    RefinedBlock block(make_start_mesh(spec));
    block.refine({0});
    block.refine({0, 3, 5, 9, block.mesh().GetNE() - 1});
    return block;
}

/// A displacement of constant strain.
void linear_field(const mfem::Vector& at, mfem::Vector& u) {
    u[0] = 0.1 + 0.2 * at[0] - 0.3 * at[1] + 0.4 * at[2];
    u[1] = 0.2 - 0.5 * at[0] + 0.1 * at[1] + 0.3 * at[2];
    u[2] = 0.3 + 0.7 * at[0] + 0.6 * at[1] - 0.2 * at[2];
}

/// Prescribes linear_field on all faces.
LoadCase given_all_around(ElasticityProblem& problem, const mfem::Vector& exact) {
    mfem::Array<int> everywhere(static_cast<int>(BoundaryPart::far));
    everywhere = 1;
    LoadCase result{{}, mfem::Vector(exact.Size()), mfem::Vector(exact.Size())};
    problem.space().GetEssentialTrueDofs(everywhere, result.essential);
    result.given = 0.0;
    result.forces = 0.0;
    for (const int dof : result.essential) result.given[dof] = exact[dof];
    return result;
}

std::array<double, 3> position(mfem::ElementTransformation& map, const mfem::IntegrationPoint& point) {
    mfem::Vector at;
    map.Transform(point, at);
    return {-at[0], -at[1], -at[2]};
}

struct Recorder : Observer {
    std::vector<double> fractions, estimates;
    bool cancel_when_refining = false, refining = false;
    void on_progress(const Progress& progress) override {
        fractions.push_back(progress.fraction);
        refining = progress.stage == "adaptive";
        if (refining) estimates.push_back(progress.residual);
    }
    bool cancelled() const override { return cancel_when_refining && refining; }
};

}  // namespace

TEST_CASE("Hanging nodes keep a linear displacement exactly", "[fem][adaptive]") {
    IcSpec spec = dimensionless(adaptive_spec(1000, 1, GENERATE(1.0, 0.3)));
    spec.fem.order = GENERATE(1, 2, 3);
    spec.fem.tolerance = 1e-12;
    CAPTURE(spec.dy, spec.fem.order);
    ElasticityProblem problem(MPI_COMM_WORLD, spec, twice_refined(spec).block());
    REQUIRE(problem.dofs() < problem.space().GetVSize());
    mfem::VectorFunctionCoefficient field(3, linear_field);
    mfem::ParGridFunction projected(&problem.space());
    projected.ProjectCoefficient(field);
    mfem::Vector exact;
    projected.GetTrueDofs(exact);

    const auto system = make_linear_system(problem, [](double, double) {});
    const LoadCase load_case = given_all_around(problem, exact);
    REQUIRE(load_case.essential.Size() < exact.Size());
    mfem::Vector u;
    const SolveMonitor nobody{[](double, std::optional<double>) {}, [](int, double, double) {}};
    REQUIRE(system->solve(load_case, u, nobody).converged);
    exact -= u;
    CHECK(exact.Normlinf() < 1e-9 * u.Normlinf());

    // Stresses do not jump, so the estimated error is zero.
    const std::vector<double> errors = energy_errors(problem, {{Axis::z, u}});
    CHECK(*std::max_element(errors.begin(), errors.end()) < 1e-8 * std::pow(12, 1.5));
}

TEST_CASE("A surface point is found in a refined mesh", "[fem][adaptive]") {
    IcSpec spec = dimensionless(adaptive_spec(1000, 1, GENERATE(1.0, 0.25, 4.0)));
    spec.load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const double L = spec.fem.L_over_h * std::max(spec.dx, spec.dy);
    ElasticityProblem problem(MPI_COMM_WORLD, spec, twice_refined(spec).block());

    std::mt19937 random(1);
    std::uniform_real_distribution<double> exponent(-3, 1);
    std::vector<std::array<double, 2>> points{{0, 0}, {L, L}, {L, 0}, {0, L}, {L, L / 3}};
    const auto [a, b] = load_extent(spec);
    for (const double s : {0.0, 0.25, 0.5, 1.0})  // on faces between elements
        for (const double t : {0.0, 0.25, 0.5, 1.0, 2.0}) points.push_back({s * a, t * b});
    for (int i = 0; i < 1000; ++i)
        points.push_back(
            {L * std::min(1.0, std::pow(10, exponent(random))), L * std::min(1.0, std::pow(10, exponent(random)))});
    double farthest = 0;
    for (const auto& [X, Y] : points) {
        const ElementPoint found = problem.locate(X, Y);
        for (const double local : {found.point.x, found.point.y}) REQUIRE((local >= 0 && local <= 1));
        const auto at = position(*problem.space().GetElementTransformation(found.element), found.point);
        farthest = std::max({farthest, std::abs(at[0] - X), std::abs(at[1] - Y), std::abs(at[2])});
    }
    CHECK(farthest < 1e-13 * L);
}

TEST_CASE("Refined faces keep the part of the boundary they belong to", "[fem][adaptive]") {
    IcSpec spec = dimensionless(adaptive_spec(1000, 1, 0.5));
    spec.load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    mfem::Mesh mesh(twice_refined(spec).mesh());
    std::array<double, 5> areas{};
    for (int i = 0; i < mesh.GetNBE(); ++i) {
        mfem::ElementTransformation& map = *mesh.GetBdrElementTransformation(i);
        map.SetIntPoint(&mfem::Geometries.GetCenter(mfem::Geometry::SQUARE));
        areas[static_cast<std::size_t>(mesh.GetBdrAttribute(i) - 1)] += map.Weight();
    }
    const auto area = [&](BoundaryPart part) { return areas[static_cast<std::size_t>(part) - 1]; };
    const double load = spec.load_shape == LoadShape::constant ? 0.5 / 4 : 0.5;
    CHECK_THAT(area(BoundaryPart::loaded), WithinRel(load, 1e-12));
    CHECK_THAT(area(BoundaryPart::free), WithinRel(144 - load, 1e-12));
    CHECK_THAT(area(BoundaryPart::front), WithinRel(144, 1e-12));
    CHECK_THAT(area(BoundaryPart::right), WithinRel(144, 1e-12));
    CHECK_THAT(area(BoundaryPart::far), WithinRel(3 * 144, 1e-12));
}

TEST_CASE("More unknowns give smaller errors, and no more than allowed are used", "[fem][adaptive]") {
    std::vector<IcEvidence> evidence;
    for (const long long max_dofs : {2000, 6000, 16000}) {
        evidence.push_back(build(adaptive_spec(max_dofs)).evidence);
        CAPTURE(max_dofs);
        CHECK(evidence.back().dofs <= max_dofs);
        CHECK(evidence.back().dofs > max_dofs / 2);
        CHECK(evidence.back().solver == "amg_pcg");
        REQUIRE(evidence.back().load_cases.size() == 3);  // the mesh need not be symmetric
        for (const LoadCaseEvidence& load_case : evidence.back().load_cases) CHECK(load_case.residual <= 1e-8);
    }
    for (std::size_t i = 1; i < evidence.size(); ++i) {
        CHECK(evidence[i].elements > evidence[i - 1].elements);
        CHECK(std::abs(evidence[i].errors.zz->origin) < 0.7 * std::abs(evidence[i - 1].errors.zz->origin));
        CHECK(std::abs(evidence[i].errors.xx->origin) < 0.7 * std::abs(evidence[i - 1].errors.xx->origin));
        CHECK(evidence[i].errors.zz->largest < evidence[i - 1].errors.zz->largest);
        CHECK(evidence[i].errors.xx->largest < evidence[i - 1].errors.xx->largest);
    }
    // This is a third of the error with the coarsest layers around the table (7e-3).
    CHECK(evidence.back().errors.zz->largest < 2e-3);
    CHECK(evidence.back().errors.xx->largest < 2e-3);
}

TEST_CASE("Any load and any shape of the elements is refined for", "[fem][adaptive]") {
    IcSpec spec = adaptive_spec(6000, 1, GENERATE(0.4, 2.0));
    spec.load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    CAPTURE(spec.dy, name_of(spec.load_shape));
    const IcEvidence evidence = build(spec).evidence;
    for (const auto& error : {evidence.errors.xx, evidence.errors.yy, evidence.errors.zz}) {
        CHECK(std::abs(error->origin) < 0.007);
        CHECK(error->largest < 0.01);
    }
    CHECK(evidence.errors.scaled_xy < 0.01);
    CHECK(evidence.errors.scaled_xz < 0.01);
}

TEST_CASE("A refined block, clamped, is the block of Mesh1", "[fem][adaptive]") {
    IcSpec spec = adaptive_spec(4000);
    spec.body = BodyShape::block;
    spec.fem.far_boundary = FarBoundary::clamped;
    spec.fem.L_over_h = 4;
    spec.nx = spec.ny = 3;
    const IcRecord adaptive = build(spec);
    spec.fem.mesh = MeshKind::hex;
    const IcTable hex = build(spec).table();
    CHECK(!adaptive.evidence.errors.zz);
    for (std::size_t i = 0; i < hex.values.size(); ++i)
        CHECK_THAT(adaptive.table().values[i], WithinAbs(hex.values[i], 1e-3));
}

TEST_CASE("The estimate falls from step to step and is shown", "[fem][adaptive]") {
    Recorder recorder;
    build_ic_table(adaptive_spec(6000), recorder);
    REQUIRE(recorder.estimates.size() >= 3);
    CHECK(std::is_sorted(recorder.estimates.rbegin(), recorder.estimates.rend()));
    const auto falls = [](double a, double b) { return b < a - 1e-12; };  // more than rounding does
    CHECK(std::adjacent_find(recorder.fractions.begin(), recorder.fractions.end(), falls) == recorder.fractions.end());
    CHECK(recorder.fractions.back() == 1);
}

TEST_CASE("Refinement can be cancelled between steps", "[fem][adaptive]") {
    Recorder recorder;
    recorder.cancel_when_refining = true;
    CHECK_THROWS_AS(build_ic_table(adaptive_spec(6000), recorder), Cancelled);
    CHECK(recorder.estimates.size() == 1);
}

TEST_CASE("A bound below the mesh to start from is refused", "[fem][adaptive]") {
    IcSpec spec = adaptive_spec(1000);
    spec.fem.order = 4;
    try {
        build(spec);
        FAIL("no exception");
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "ics.max_dofs");
        CHECK_THAT(error.what(), ContainsSubstring("4035 unknowns of order 4"));
    }
}

TEST_CASE("What describes Mesh1 does not change an adaptive table", "[fem][adaptive]") {
    IcSpec spec = adaptive_spec(2000);
    const IcRecord plain = build(spec);
    spec.fem.h_over_hs = 8;
    spec.fem.f = 1;
    spec.fem.t1_over_hs = 0.001;
    const IcRecord other = build(spec);
    CHECK(plain.spec == other.spec);
    CHECK(plain.table().values == other.table().values);
}
