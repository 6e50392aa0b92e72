#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cstring>
#include <limits>

#include "contactd/finite.hpp"
#include "contactd/proto/message.hpp"
#include "wire.hpp"

using namespace contactd::proto;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

const std::vector<double> six{0.1, -2, 3e-310, 4e300, 5, -0.0};

std::string bytes_of(const std::vector<double>& values) {
    std::string bytes(values.size() * sizeof(double), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

std::string refusal_of(const json& array, const Frames& frames, const std::string& field = "gap.array") {
    const auto status = wire::status_thrown_by([&] { read_array(array, frames, {2, 3}, field); });
    REQUIRE(status);
    CHECK(status->code == StatusCode::invalid_argument);
    CHECK(status->reason == "ARRAY_INVALID");
    REQUIRE(status->violations.size() == 1);
    CHECK(status->violations[0].field == field);
    return status->message;
}

json reference(const json& frame, const json& dtype = "<f8", const json& shape = {2, 3}) {
    return {{"$array", {{"frame", frame}, {"dtype", dtype}, {"shape", shape}}}};
}

}  // namespace

TEST_CASE("An array of doubles comes back bit for bit", "[arrays]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    ArrayWriter writer(encoding);
    const json written = writer.write(std::span<const double>(six), {2, 3});
    const Frames frames = writer.take_frames();

    const auto read = read_array(json::parse(dump(written)), frames, {2, 3}, "a");

    CHECK(frames.size() == (encoding == ArrayEncoding::frame ? 1 : 0));
    REQUIRE(read.size() == 6);
    CHECK(std::memcmp(read.data(), six.data(), 6 * sizeof(double)) == 0);
}

TEST_CASE("An array of bytes comes back", "[arrays]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    const std::vector<unsigned char> bytes{0, 1, 2, 255};
    ArrayWriter writer(encoding);
    const json written = writer.write(std::span<const unsigned char>(bytes), {1, 4});

    CHECK(read_byte_array(written, writer.take_frames(), {1, 4}, "a") == bytes);
}

TEST_CASE("Frames are little-endian, in C order and numbered from 1", "[arrays]") {
    ArrayWriter writer(ArrayEncoding::frame);
    writer.write(std::span<const double>(six), {6});
    const std::vector<double> one{1.0};
    const json second = writer.write(std::span<const double>(one), {1, 1});

    CHECK(second == json::parse(R"({"$array": {"frame": 2, "dtype": "<f8", "shape": [1, 1]}})"));
    CHECK(writer.take_frames()[1] == std::string("\0\0\0\0\0\0\xf0\x3f", 8));
}

TEST_CASE("An array that is handed over becomes a frame as it is", "[arrays]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    ArrayWriter writer(encoding);
    contactd::UnsetArray values(six.begin(), six.end());
    const void* memory = values.data();
    const json written = writer.write_finite(std::move(values), {2, 3});
    const Frames frames = writer.take_frames();

    CHECK(read_array(written, frames, {2, 3}, "a") == six);
    if (encoding == ArrayEncoding::frame) CHECK(frames.at(0).data() == memory);
}

TEST_CASE("A list is nested as its shape says", "[arrays]") {
    const std::vector<double> values{1, 2, 3, 4, 5, 6, 7, 8};
    ArrayWriter writer(ArrayEncoding::list);
    CHECK(writer.write(std::span<const double>(values), {2, 2, 2}) ==
          json::parse("[[[1.0,2.0],[3.0,4.0]],[[5.0,6.0],[7.0,8.0]]]"));
}

TEST_CASE("An array that is not finite or has another shape is not written", "[arrays]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    ArrayWriter writer(encoding);
    const std::vector<double> bad{0, std::numeric_limits<double>::quiet_NaN(), 0,
                                  std::numeric_limits<double>::infinity()};

    CHECK_THROWS_AS(writer.write(std::span<const double>(bad), {2, 2}), contactd::NotFinite);
    CHECK_THROWS_AS(writer.write(std::span<const double>(six), {2, 2}), contactd::Error);
    CHECK_THROWS_AS(writer.write_finite(contactd::UnsetArray(six.begin(), six.end()), {2, 2}), contactd::Error);
}

TEST_CASE("Integers are numbers too", "[arrays]") {
    CHECK(read_array(json::parse("[[1, 2, 3], [4, 5, 6]]"), {}, {2, 3}, "a") == std::vector<double>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("A list that does not fit is refused with the place", "[arrays]") {
    CHECK_THAT(refusal_of(json::parse("[[1,2,3]]"), {}),
               ContainsSubstring("has 1 values") && ContainsSubstring("[2, 3]"));
    CHECK_THAT(refusal_of(json::parse("[[1,2,3],[4,5]]"), {}), ContainsSubstring("has 2 values at [1]"));
    CHECK_THAT(refusal_of(json::parse("[1,2,3,4,5,6]"), {}), ContainsSubstring("has 6 values"));
    CHECK_THAT(refusal_of(json::parse("[1,2]"), {}), ContainsSubstring("contains 1 at [0]; it must be a list of 3"));
    CHECK_THAT(refusal_of(json::parse("[[1,2,3],[4,\"x\",6]]"), {}), ContainsSubstring("contains \"x\" at [1, 1]"));
    CHECK_THAT(refusal_of(json::parse("[[1,2,3],[4,null,6]]"), {}), ContainsSubstring("contains null at [1, 1]"));
    CHECK_THAT(refusal_of(json::parse("[[1,2,3],[4,[5],6]]"), {}),
               ContainsSubstring("contains a list with 1 value at [1, 1]"));
    CHECK_THAT(refusal_of(json::parse("[]"), {}), ContainsSubstring("has 0 values"));
    CHECK_THAT(refusal_of(json::parse("7"), {}), ContainsSubstring("is 7; it must be a list"));
    CHECK_THAT(refusal_of(json::parse("{}"), {}), ContainsSubstring("is an object without fields"));
}

TEST_CASE("A reference to a frame that is not there is refused", "[arrays]") {
    const Frames one{bytes_of(six)};
    CHECK_THAT(refusal_of(reference(0), one), ContainsSubstring("frame 0; there is only frame 1"));
    CHECK_THAT(refusal_of(reference(2), one), ContainsSubstring("frame 2"));
    CHECK_THAT(refusal_of(reference(-1), one), ContainsSubstring("frame -1"));
    CHECK_THAT(refusal_of(reference(1), {}), ContainsSubstring("no frame follows"));
    CHECK_THAT(refusal_of(reference(3), {"", ""}), ContainsSubstring("frames 1 to 2"));
    CHECK_THAT(refusal_of(reference(1.5), one), ContainsSubstring("frame 1.5"));
    CHECK_THAT(refusal_of(reference("1"), one), ContainsSubstring("frame \"1\""));
    CHECK_THAT(refusal_of(reference(std::numeric_limits<std::int64_t>::max()), one), ContainsSubstring("frame 9223"));
}

TEST_CASE("A reference whose type, shape or bytes do not fit is refused", "[arrays]") {
    const Frames frame{bytes_of(six)};
    CHECK_THAT(refusal_of(reference(1, ">f8"), frame), ContainsSubstring("dtype \">f8\"; it must be \"<f8\""));
    CHECK_THAT(refusal_of(reference(1, "|u1"), frame), ContainsSubstring("\"<f8\""));
    CHECK_THAT(refusal_of(reference(1, 8), frame), ContainsSubstring("dtype 8"));
    for (const json& shape : {json{3, 2}, json{6}, json{2, 3, 1}, json::array(), json{2.0, 3.0}, json{-2, -3},
                              json("2,3"), json{4294967298, 3}, json{2, nullptr}})
        CHECK_THAT(refusal_of(reference(1, "<f8", shape), frame), ContainsSubstring("it must be [2, 3]"));
    CHECK_THAT(refusal_of(reference(1), {std::string(frame[0].bytes().substr(1))}),
               ContainsSubstring("47 bytes") && ContainsSubstring("6 * 8"));
    CHECK_THAT(refusal_of(reference(1), {std::string(frame[0].bytes()) + "x"}), ContainsSubstring("49 bytes"));
    CHECK_THAT(refusal_of(reference(1), {""}), ContainsSubstring("0 bytes"));
    CHECK_THAT(refusal_of(json::parse(R"({"$array": {"frame": 1, "dtype": "<f8"}})"), frame),
               ContainsSubstring("lacks shape"));
    CHECK_THAT(refusal_of(json::parse(R"({"$array": 1})"), frame), ContainsSubstring("$array"));
}

TEST_CASE("A value of a frame that is not finite is refused with its place", "[arrays]") {
    std::vector<double> values = six;
    values[4] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THAT(refusal_of(reference(1), {bytes_of(values)}), ContainsSubstring("NaN at [1, 1]"));
    values[2] = -std::numeric_limits<double>::infinity();
    CHECK_THAT(refusal_of(reference(1), {bytes_of(values)}), ContainsSubstring("infinity at [0, 2]"));
}

TEST_CASE("Bytes out of range are refused", "[arrays]") {
    for (const char* text : {"[[1, 256]]", "[[1, -1]]", "[[1, 1.5]]", "[[1, \"1\"]]"}) {
        const auto status = wire::status_thrown_by([&] { read_byte_array(json::parse(text), {}, {1, 2}, "a"); });
        REQUIRE(status);
        CHECK(status->reason == "ARRAY_INVALID");
    }
}

TEST_CASE("A frame that nothing refers to is refused", "[arrays]") {
    const json params{{"gap", {{"array", reference(1)}}}, {"initial", {{"pressure", reference(3)}}}};
    CHECK_NOTHROW(check_frames_used(json::object(), {}));
    CHECK_NOTHROW(check_frames_used(params, {"a"}));

    const auto status = wire::status_thrown_by([&] { check_frames_used(params, {"a", "b", "c"}); });

    REQUIRE(status);
    CHECK(status->reason == "ARRAY_INVALID");
    CHECK_THAT(status->message, ContainsSubstring("frame 2 is not used"));
}
