// contact.subsurface.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

SubsurfaceRequest request() {
    SubsurfaceRequest request;
    request.grid = {3, 2, 0.5, 0.25, -1, 2};
    request.nu = 0.28;
    request.body = ContactBody::upper;
    request.pressure = {0, 1, 2, 0, 3, 0};
    request.traction_y = {0, 0.1 + 0.2, 0, 0, 1e-300, 0};
    request.points = StressBlock{{0, 1}, {-1, 0, 1.0 / 3}, {0, -0.5}};
    return request;
}

json sent(const json& message) {
    return json::parse(dump(message));
}

std::string refusal_of(const json& params, const Frames& frames = {}, const MessageLimits& limits = {}) {
    const auto status = wire::status_thrown_by([&] {
        check_params("contact.subsurface", params);
        decode_subsurface_request(params, frames, limits);
    });
    return status ? status->reason + ": " + status->message : "taken";
}

json reference(std::vector<std::size_t> shape) {
    return {{"$array", {{"frame", 1}, {"dtype", "<f8"}, {"shape", std::move(shape)}}}};
}

}  // namespace

TEST_CASE("Stresses inside a block are refused", "[codec]") {
    SubsurfaceRequest original = request();
    original.ics.source = IcSource::fem;
    ArrayWriter arrays(ArrayEncoding::list);
    CHECK(refusal_of(sent(encode_subsurface_request(original, arrays))) == "taken");
    original.ics.body = BodyShape::block;
    CHECK_THAT(refusal_of(sent(encode_subsurface_request(original, arrays))),
               ContainsSubstring("ics.body is block") && ContainsSubstring("half-space"));
}

TEST_CASE("A request for stresses arrives as it was sent", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    const bool at_points = GENERATE(false, true);
    SubsurfaceRequest original = request();
    const StressPoints points{{1, 2, -3}, {0, 0, 0}};
    if (at_points) original.points = points;
    ArrayWriter arrays(encoding);
    const json params = sent(encode_subsurface_request(original, arrays));
    const auto frames = arrays.take_frames();
    CHECK_NOTHROW(check_params("contact.subsurface", params));
    CHECK_NOTHROW(check_frames_used(params, frames));

    const SubsurfaceRequest read = decode_subsurface_request(params, frames);

    CHECK(read.grid == original.grid);
    CHECK(read.nu == 0.28);
    CHECK(read.body == ContactBody::upper);
    CHECK(read.pressure == original.pressure);
    CHECK(read.traction_x.empty());
    CHECK(read.traction_y == original.traction_y);
    CHECK(read.shape() == original.shape());
    if (at_points) {
        CHECK(std::get<StressPoints>(read.points) == points);
        return;
    }
    const StressBlock &block = std::get<StressBlock>(read.points), &expected = std::get<StressBlock>(original.points);
    CHECK(block.x == expected.x);
    CHECK(block.y == expected.y);
    CHECK(block.z == expected.z);
}

TEST_CASE("The lower body is the one meant when none is named", "[codec]") {
    CHECK(decode_subsurface_request(wire::subsurface_params(), {}).body == ContactBody::lower);
}

TEST_CASE("Stresses come back exactly", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    SubsurfaceReply reply;
    reply.shape = {2, 1, 2};
    double next = 0.1;
    SubsurfaceStress& stress = reply.stress;
    for (auto* values : {&stress.xx, &stress.yy, &stress.zz, &stress.xy, &stress.xz, &stress.yz})
        for (int i = 0; i < 4; ++i) values->push_back(next *= -1.1);
    stress.von_mises = {1, 3, 3, 2};
    stress.largest = 1;
    reply.largest = {3, 0.5, -1, -2};
    ArrayWriter arrays(encoding);

    const json result = sent(encode_subsurface_reply(reply, arrays));
    CHECK(violations_of("contact.subsurface.result", result).empty());
    CHECK(result["largest"]["depth"] == 2);
    const SubsurfaceReply read = decode_subsurface_reply(result, arrays.take_frames());

    CHECK(read.shape == reply.shape);
    CHECK(read.stress.xx == stress.xx);
    CHECK(read.stress.yy == stress.yy);
    CHECK(read.stress.zz == stress.zz);
    CHECK(read.stress.xy == stress.xy);
    CHECK(read.stress.xz == stress.xz);
    CHECK(read.stress.yz == stress.yz);
    CHECK(read.stress.von_mises == stress.von_mises);
    CHECK(read.stress.largest == 1);
    CHECK(read.largest.von_mises == 3);
    CHECK(read.largest.x == 0.5);
    CHECK(read.largest.y == -1);
    CHECK(read.largest.z == -2);
}

TEST_CASE("A depth on the surface is no negative zero", "[codec]") {
    CHECK_FALSE(std::signbit(LargestStress{1, 0, 0, 0}.depth()));
    CHECK_FALSE(std::signbit(LargestStress{1, 0, 0, -0.0}.depth()));
}

TEST_CASE("Stresses that are not finite are not sent", "[codec]") {
    SubsurfaceReply reply;
    reply.shape = {1};
    for (auto* values : {&reply.stress.xx, &reply.stress.yy, &reply.stress.zz, &reply.stress.xy, &reply.stress.xz,
                         &reply.stress.yz, &reply.stress.von_mises})
        *values = {std::numeric_limits<double>::infinity()};
    ArrayWriter arrays(ArrayEncoding::frame);
    CHECK_THROWS_AS(encode_subsurface_reply(reply, arrays), Error);
}

TEST_CASE("A bad field of a request for stresses is named", "[codec]") {
    struct Case {
        const char* pointer;
        const char* value;
        const char* says;
    };
    const auto c = GENERATE(
        Case{"/nu", "0.51", "FIELD_INVALID: nu is 0.51; it must lie in [0, 0.5]"},
        Case{"/body", "\"both\"", "body is \"both\"; it must be one of \"upper\", \"lower\""},
        Case{"/grid/nx", "0", "grid.nx is 0"}, Case{"/E", "1", "E is not a field of contact.subsurface"},
        Case{"/G", "0", "G is 0; it must be"},
        Case{"/pressure", "[1, 2, 3]", "ARRAY_INVALID: pressure has 3 values; it must have 2"},
        Case{"/pressure", "[[1, 2, 3], [1e101, 0, 0]]", "pressure contains 1e+101; its values must lie in"},
        Case{"/traction_x", "[[1, 2, 3]]", "traction_x has 1 values"},
        Case{"/traction_y", "7", "traction_y is 7; it must be a list of numbers"},
        Case{"/points", "[[0, 0, 0]]", "block cannot be combined with points; remove one of them"},
        Case{"/block", "{\"x\": [0], \"y\": [0]}", "block.z is missing"}, Case{"/block", "{}", "block.x is missing"},
        Case{"/block", "[[0, 0, 0]]", "block is a list with 1 value"},
        Case{"/block/x", "[[0]]", "block.x contains a list with 1 value at [0]; it must be a number"},
        Case{"/block/x", "[\"0\"]", "block.x contains \"0\" at [0]; it must be a number"},
        Case{"/block/dz", "1", "block.dz is not a field of block"});
    CAPTURE(c.pointer, c.value);
    json params = wire::subsurface_params();
    params[json::json_pointer(c.pointer)] = json::parse(c.value);
    CHECK_THAT(refusal_of(params), ContainsSubstring(c.says));
}

TEST_CASE("Points are triples", "[codec]") {
    json params = wire::subsurface_params();
    params.erase("block");
    CHECK_THAT(refusal_of(params), ContainsSubstring("block is missing") || ContainsSubstring("points is missing"));
    const auto refused = [&](const char* points) {
        params["points"] = json::parse(points);
        return refusal_of(params);
    };
    CHECK_THAT(refused("[]"), ContainsSubstring("ARRAY_INVALID: points has shape [0]; it must be [n,3]"));
    CHECK_THAT(refused("[0, 0, 0]"), ContainsSubstring("points has shape [3]; it must be [n,3]"));
    CHECK_THAT(refused("[[0, 0]]"), ContainsSubstring("points has shape [1,2]; it must be [n,3]"));
    CHECK_THAT(refused("[[0, 0, 0], [0, 0]]"), ContainsSubstring("points has 2 values at [1]; it must have 3"));
    CHECK_THAT(refused("[[0, 0, [0]]]"), ContainsSubstring("points contains a list"));
    CHECK(refused("[[0, 0, 0], [0, 0, -1]]") == "taken");
}

TEST_CASE("The stresses asked for are limited before they take memory", "[codec]") {
    json params = wire::subsurface_params();
    SECTION("of a block") {
        params["block"] = json::parse(R"({"x": [1, 2, 3], "y": [1, 2], "z": [0, -1]})");
        CHECK(refusal_of(params, {}, {.max_array_elements = 84}) == "taken");
        CHECK_THAT(refusal_of(params, {}, {.max_array_elements = 83}),
                   ContainsSubstring("LIMIT_EXCEEDED: block has 12 points; at most 11 are allowed"));
    }
    SECTION("of points") {
        params.erase("block");
        params["points"] = json::parse("[[1, 2, -3], [1, 2, -3]]");
        CHECK(refusal_of(params, {}, {.max_array_elements = 14}) == "taken");
        CHECK_THAT(refusal_of(params, {}, {.max_array_elements = 13}),
                   ContainsSubstring("LIMIT_EXCEEDED: points has 2 points; at most 1 are allowed"));
    }
    SECTION("of axes that say they are huge") {
        for (const char* axis : {"x", "y", "z"}) params["block"][axis] = reference({4'000'000});
        CHECK_THAT(refusal_of(params, {""}), ContainsSubstring("LIMIT_EXCEEDED: block has"));
        params["block"]["y"] = params["block"]["z"] = json::array({0});
        CHECK_THAT(refusal_of(params, {""}), ContainsSubstring("LIMIT_EXCEEDED: block has"));
        params["block"]["y"] = json::array();
        CHECK_THAT(refusal_of(params, {""}), ContainsSubstring("LIMIT_EXCEEDED: block has"));
    }
}
