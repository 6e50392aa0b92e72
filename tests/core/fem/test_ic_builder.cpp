#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

#include "contactd/fem/ic_builder.hpp"
#include "contactd/half_space.hpp"
#include "fem_specs.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;

namespace {

constexpr std::array axes{Axis::x, Axis::y, Axis::z};

IcRecord build(const IcSpec& spec) {
    Observer observer;
    return fem::build_ic_table(spec, observer);
}

double largest(const IcTable& table) {
    double result = 0;
    for (const double value : table.values) result = std::max(result, std::abs(value));
    return result;
}

double largest_difference(const IcTable& a, const IcTable& b) {
    REQUIRE(a.values.size() == b.values.size());
    double result = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) result = std::max(result, std::abs(a.values[i] - b.values[i]));
    return result;
}

/// Returns the table with x and y exchanged.
IcTable mirrored(const IcTable& table) {
    const auto other = [](Axis axis) { return axis == Axis::x ? Axis::y : axis == Axis::y ? Axis::x : Axis::z; };
    IcTable result(table.ny, table.nx);
    for (const Axis i : axes)
        for (const Axis j : axes)
            for (int l = 0; l < table.ny; ++l)
                for (int k = 0; k < table.nx; ++k) result(other(i), other(j), l, k) = table(i, j, k, l);
    return result;
}

struct Recorder : Observer {
    std::vector<double> fractions;
    std::string cancel_in;  ///< stage, or never
    std::string stage;
    void on_progress(const Progress& progress) override {
        fractions.push_back(progress.fraction);
        stage = progress.stage;
    }
    bool cancelled() const override { return stage == cancel_in; }
};

}  // namespace

TEST_CASE("All nine components have the half-space's size and sign", "[fem]") {
    IcSpec spec = paper_spec("paper-test3", 1024);
    spec.nx = 4;
    spec.ny = 3;
    spec.dy = 1;  // the y case is solved, not mirrored
    const IcRecord record = build(spec);
    IcSpec closed = record.spec;
    closed.source = IcSource::analytic;
    const IcTable expected = half_space_table(closed);
    for (const Axis i : axes)
        for (const Axis j : axes) {
            CAPTURE(static_cast<int>(i), static_cast<int>(j));
            for (int l = 0; l < spec.ny; ++l)
                for (int k = 0; k < spec.nx; ++k)
                    CHECK_THAT(record.table()(i, j, k, l), WithinAbs(expected(i, j, k, l), 1.5e-3));
        }
    CHECK(largest(expected) > 0.3);
}

TEST_CASE("The table does not depend on shear modulus and element size", "[fem]") {
    const IcRecord steel = build(coarse_spec(3, 2, 0.8, 0.4));
    IcSpec spec = coarse_spec(3, 2, 2, 1);
    spec.material.G = 1;
    const IcRecord soft = build(spec);
    CHECK(steel.spec == soft.spec);
    CHECK(steel.spec.dx == 1);
    CHECK(steel.table().values == soft.table().values);
}

TEST_CASE("Exchanging x and y exchanges the components", "[fem]") {
    const IcTable broad = build(coarse_spec(4, 3, 2, 1)).table();                  // per dx = 2
    const IcTable tall = scaled(build(coarse_spec(3, 4, 1, 2)).table(), 1.0 / 2);  // per dx = 1
    CHECK(largest_difference(broad, mirrored(tall)) < 1e-6 * largest(broad));
}

TEST_CASE("With square elements the y case is the x case mirrored", "[fem]") {
    const IcRecord square = build(coarse_spec(4, 3, 1, 1));
    const IcRecord nearly = build(coarse_spec(4, 3, 1, 1 + 1e-9));
    REQUIRE(square.evidence.load_cases.size() == 2);
    REQUIRE(nearly.evidence.load_cases.size() == 3);
    CHECK(nearly.evidence.load_cases.back().load == Axis::y);
    CHECK(largest_difference(square.table(), nearly.table()) < 1e-6 * largest(square.table()));
}

TEST_CASE("Linear sampling costs what the surface mesh's stretching costs", "[fem]") {
    const auto cost = [](const char* preset, Sampling sampling) {
        IcSpec spec = paper_spec(preset, 512);
        const IcTable exact = build(spec).table();
        spec.fem.sampling = sampling;
        const IcTable linear = build(spec).table();
        double result = 0;
        for (int l = 0; l < spec.ny; ++l)
            for (int k = 0; k < spec.nx; ++k)
                result = std::max(result, std::abs(linear(Axis::z, Axis::z, k, l) / exact(Axis::z, Axis::z, k, l) - 1));
        return result;
    };
    CHECK_THAT(cost("paper-test3", Sampling::linear), WithinAbs(0.012, 0.002));
    CHECK_THAT(cost("paper-test2", Sampling::linear), WithinAbs(0.038, 0.004));
    // Half the interval leaves about a quarter of the error.
    CHECK_THAT(cost("paper-test3", Sampling::linear_nodes), WithinAbs(0.0038, 0.0005));
    CHECK_THAT(cost("paper-test2", Sampling::linear_nodes), WithinAbs(0.0103, 0.0015));
}

TEST_CASE("The evidence says what was built and solved", "[fem]") {
    const IcSpec spec = coarse_spec(2, 2, 1, 1);
    const IcRecord record = build(spec);
    const IcEvidence& evidence = record.evidence;
    CHECK(evidence.source == "fem");
    CHECK_THAT(evidence.version,
               ContainsSubstring("contactd ") && ContainsSubstring("MFEM ") && ContainsSubstring("hypre "));
    CHECK(evidence.elements == mesh_size(spec).elements);
    CHECK(evidence.processes == 1);
    CHECK(evidence.seconds.assembly > 0);
    CHECK(evidence.seconds.setup > 0);
    CHECK(evidence.seconds.solve > 0);
    CHECK(evidence.seconds.total >= evidence.seconds.assembly + evidence.seconds.setup + evidence.seconds.solve);
    for (const LoadCaseEvidence& load_case : evidence.load_cases) {
        CHECK(load_case.iterations > 1);
        CHECK(load_case.residual > 0);
    }
}

TEST_CASE("The true residual meets a tight tolerance", "[fem]") {
    IcSpec spec = coarse_spec(2, 2, 1, 1);
    spec.fem.tolerance = 1e-12;
    for (const LoadCaseEvidence& load_case : build(spec).evidence.load_cases) CHECK(load_case.residual <= 1e-12);
}

TEST_CASE("A solve that misses its tolerance says how far it came", "[fem]") {
    IcSpec spec = coarse_spec(2, 2, 1, 1);
    spec.fem.max_iterations = 2;
    CHECK_THROWS_AS(build(spec), NotConverged);
    CHECK_THROWS_WITH(build(spec),
                      ContainsSubstring("load case z") && ContainsSubstring("after 2 of at most 2 iterations"));
}

TEST_CASE("Progress grows from 0 to 1", "[fem]") {
    Recorder recorder;
    fem::build_ic_table(coarse_spec(2, 2, 1, 1), recorder);
    CHECK(recorder.fractions.front() == 0);
    CHECK(recorder.fractions.back() == 1);
    CHECK(std::is_sorted(recorder.fractions.begin(), recorder.fractions.end()));
}

TEST_CASE("A build can be cancelled in every stage", "[fem]") {
    for (const char* stage : {"assembly", "amg_setup", "pcg", "sampling"}) {
        CAPTURE(stage);
        Recorder recorder;
        recorder.cancel_in = stage;
        CHECK_THROWS_AS(fem::build_ic_table(coarse_spec(2, 2, 1, 1), recorder), Cancelled);
        CHECK(recorder.stage == stage);
    }
}

TEST_CASE("A spec that finite elements cannot serve is refused", "[fem]") {
    IcSpec spec = coarse_spec(2, 2, 1, 1);
    SECTION("closed form") {
        spec.source = IcSource::analytic;
    }
    SECTION("incompressible") {
        spec.material.nu = 0.5;
    }
    SECTION("load edge inside an element") {
        spec.fem.h_over_hs = 3;
    }
    SECTION("offsets outside the block") {
        spec.nx = 41;
    }
    CHECK_THROWS_AS(build(spec), InvalidArgument);
}
