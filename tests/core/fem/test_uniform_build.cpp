#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>

#include "contactd/closed_form_record.hpp"
#include "contactd/error.hpp"
#include "contactd/fem/ic_builder.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

IcSpec edge_spec() {
    IcSpec spec;
    spec.source = IcSource::fem;
    spec.body = BodyShape::longitudinally_uniform;
    spec.accuracy = 1e-2;
    spec.section = Section{EdgeBlock{100, 50, 1}};
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.5;
    spec.nx = 21;
    spec.ny = 20;
    return spec;
}

IcRecord build(const IcSpec& spec) {
    Observer observer;
    return fem::build_ic_table(spec, observer);
}

}  // namespace

TEST_CASE("A uniform body's record meets the reference of a block with an edge, and says how it was made",
          "[uniform]") {
    const IcSpec spec = edge_spec();
    const IcRecord record = build(spec);
    const auto table = std::get<StripTable>(body_table(record, spec));
    REQUIRE(record.evidence.section);
    const double bound = record.evidence.section->error + 1e-4;
    CHECK(record.evidence.section->error <= 1e-2);
    CHECK(std::abs(table(Axis::z, Axis::z, 19, 19, 0) * 82000 - 0.220063) < bound * 0.201996);
    CHECK(std::abs(table(Axis::y, Axis::y, 19, 19, 4) * 82000 - 0.042699) < bound * 0.201996);
    CHECK(record.evidence.dofs > 1000);
    CHECK(record.evidence.warnings.empty());
}

TEST_CASE("Rotated half-spaces differ from finite elements far from an edge by little", "[uniform]") {
    IcSpec spec = edge_spec();
    spec.section = Section{EdgeBlock{1000, 1000, 200}};
    const auto computed = std::get<StripTable>(body_table(build(spec), spec));
    spec.source = IcSource::analytic;
    spec.accuracy = 0;
    const auto rotated = std::get<StripTable>(body_table(closed_form_record(spec), spec));
    REQUIRE(computed.values.size() == rotated.values.size());
    double largest = 0;
    for (std::size_t i = 0; i < rotated.values.size(); ++i)
        largest = std::max(largest, std::abs(computed.values[i] - rotated.values[i]));
    CHECK(largest < 1e-2 * rotated(Axis::z, Axis::z, 0, 0, 0));
}

TEST_CASE("A rail clamped at its foot comes with a warning", "[uniform]") {
    IcSpec spec = edge_spec();
    spec.ny = 6;
    spec.section = Section{RailSection{0, RailSupport::foot, 0}};
    CHECK(build(spec).evidence.warnings.size() == 1);
}

TEST_CASE("A longitudinally uniform body that can not be built is refused with the field", "[uniform]") {
    IcSpec spec = edge_spec();
    spec.section = Section{EdgeBlock{5, 5, 0}};
    CHECK_THROWS_MATCHES(build(spec), InvalidArgument, MessageMatches(ContainsSubstring("ics.section")));
    spec = edge_spec();
    spec.section->free = true;
    CHECK_THROWS_MATCHES(build(spec), InvalidArgument, MessageMatches(ContainsSubstring("ics.section.free")));
    spec = edge_spec();
    spec.material.nu = 0.4999;
    CHECK_THROWS_MATCHES(build(spec), InvalidArgument, MessageMatches(ContainsSubstring("material.nu")));
    spec = edge_spec();
    spec.load_shape = LoadShape::bilinear;
    CHECK_THROWS_MATCHES(build(spec), InvalidArgument, MessageMatches(ContainsSubstring("ics.load_shape")));
    spec = edge_spec();
    spec.any_nu = true;
    CHECK_THROWS_MATCHES(build(spec), InvalidArgument, MessageMatches(ContainsSubstring("ics.any_nu")));
}
