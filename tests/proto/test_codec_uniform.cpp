#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/import_codec.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/status.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using nlohmann::json;

namespace {

IcSpec uniform_spec(const Section& section) {
    IcSpec spec;
    spec.source = IcSource::fem;
    spec.body = BodyShape::longitudinally_uniform;
    spec.accuracy = 1e-3;
    spec.section = section;
    spec.material = {82000, 0.28};
    spec.dx = 0.5;
    spec.dy = 0.25;
    spec.nx = 5;
    spec.ny = 2;
    return spec;
}

json params_with(const json& section) {
    json params = wire::ic_params();
    params["ics"] = {{"source", "fem"}, {"body", "longitudinally_uniform"}, {"accuracy", 1e-3}, {"section", section}};
    return params;
}

}  // namespace

TEST_CASE("Every section goes over the wire as it is") {
    const Outline outline{{-5, 0},
                          {{LineTo{{5, 0}}, false}, {SplineTo{{{6, -1}, {5, -5}}}, true}, {ArcTo{{-5, 0}, 9}, true}}};
    const Section section = GENERATE_COPY(
        Section{RailSection{0.025, RailSupport::foot, 2}}, Section{WheelRimSection{50, 1}},
        Section{EdgeBlock{100, 50, 1}, 2, 0.1}, Section{Groove{10, 10, 60, 70}}, Section{RoundEnd{9.7, 60}},
        Section{Disc{10, 1}}, Section{PlateHole{10, 100}}, Section{Slab{1, 100}},
        Section{ProfileSection{{ProfileKind::rail, ProfilePoints{{{-9, 1}, {0, 0}, {9, 2}}, 10, true}}, 60, 1}},
        Section{ProfileSection{{ProfileKind::wheel, S1002{}}, 50}},
        Section{ProfileSection{{ProfileKind::rail, ArcProfile{300, 0, -20, 20}}, 50}},
        Section{OutlineSection{outline, {outline}, 1, 2, 0.3}});
    const IcSpec spec = uniform_spec(section);
    const json params = encode_ic_spec(spec);
    CHECK(violations_of("ic.get.params", params).empty());
    CHECK(decode_ic_spec(params) == spec);
}

TEST_CASE("A section has exactly one shape, and its parts one curve") {
    CHECK_NOTHROW(decode_ic_spec(params_with({{"slab", {{"thickness", 1}, {"width", 2}}}})));
    CHECK_THROWS_AS(decode_ic_spec(params_with(json::object())), StatusError);
    const json two{{"slab", {{"thickness", 1}, {"width", 2}}}, {"disc", {{"radius", 1}, {"core", 0.1}}}};
    CHECK_THROWS_AS(decode_ic_spec(params_with(two)), StatusError);
    const json no_curve{
        {"outside", {{"start", {{"y", 0}, {"z", 0}}}, {"parts", {{{"clamped", true}}, {{"clamped", false}}}}}}};
    CHECK_THROWS_AS(decode_ic_spec(params_with({{"outline", no_curve}})), StatusError);
}

TEST_CASE("Points of a profile may come in a frame, and are refused when they are none") {
    const std::array<double, 6> points{-9, 1, 0, 0, 9, 2};
    ArrayWriter arrays(ArrayEncoding::frame);
    const json written = arrays.write(std::span<const double>(points), {3, 2});
    const Frames frames = arrays.take_frames();
    const auto params = [](const json& points_of_profile) {
        return params_with(
            {{"profile_section", {{"kind", "rail"}, {"profile", {{"points", points_of_profile}}}, {"depth", 9}}}});
    };
    CHECK(violations_of("ic.get.params", params(written)).empty());
    const IcSpec spec = decode_ic_spec(params(written), frames);
    const auto& profile = std::get<ProfileSection>(spec.section->shape).profile;
    CHECK(std::get<ProfilePoints>(profile.shape).points[2] == ProfilePoint{9, 2});
    CHECK_THROWS_AS(decode_ic_spec(params(written)), StatusError);
    CHECK_THROWS_AS(decode_ic_spec(params(json{{1, 2, 3}}), frames), StatusError);
    CHECK_FALSE(
        violations_of("ic.get.params", params_with({{"profile_section", {{"kind", "rail"}, {"depth", 9}}}})).empty());
    CHECK_FALSE(
        violations_of("ic.get.params",
                      params_with({{"profile_section", {{"kind", "rail"}, {"profile", json::object()}, {"depth", 9}}}}))
            .empty());
}

TEST_CASE("A longitudinally uniform body's table comes with its frames and how it was made") {
    IcReply reply;
    reply.key = std::string(64, 'a');
    reply.origin = "built";
    reply.spec = uniform_spec(Section{Slab{1, 100}});
    reply.table = IcTable(5, table_rows(reply.spec));
    for (std::size_t i = 0; i < reply.table.values.size(); ++i) reply.table.values[i] = static_cast<double>(i);
    reply.frames = {{1, 2, 0.1}, {3, 4, 0.2}};
    reply.evidence.source = "fem";
    reply.evidence.version = "test";
    reply.evidence.elements = 100;
    reply.evidence.section = SectionEvidence{4, 21, 6e-4, 3e-4, 2e-4, 1e-4, 5e-4};
    ArrayWriter arrays(ArrayEncoding::frame);
    const json result = encode_ic_reply(reply, arrays);
    const Frames frames = arrays.take_frames();
    CHECK(violations_of("ic.get.result", result).empty());
    const IcReply back = decode_ic_reply(result, frames);
    CHECK(back.spec == reply.spec);
    CHECK(back.table == reply.table);
    CHECK(back.frames == reply.frames);
    CHECK(back.evidence.section == reply.evidence.section);
}
