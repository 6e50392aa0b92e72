#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <numeric>

#include "contactd/proto/ic_part.hpp"
#include "contactd/proto/schema.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using Catch::Matchers::ContainsSubstring;

namespace {

MessageLimits frames_of(std::size_t bytes) {
    MessageLimits limits;
    limits.max_frame_bytes = bytes;
    return limits;
}

IcReply counting_reply(int nx, int ny) {
    IcReply reply{"key", "closed_form", {}, IcTable(nx, ny), {}};
    std::iota(reply.table.values.begin(), reply.table.values.end(), 0.0);
    reply.spec.material = {1, 0.3};
    reply.spec.nx = nx;
    reply.spec.ny = ny;
    reply.spec.dx = reply.spec.dy = 1;
    reply.evidence.source = "analytic";
    return reply;
}

}  // namespace

TEST_CASE("A table goes in pieces and comes together again", "[ic_part]") {
    const int nx = 5, ny = 7;
    const IcReply reply = counting_reply(nx, ny);
    const auto bytes = GENERATE(as<std::size_t>{}, 8 * 5, 8 * 5 + 7, 8 * 5 * 4, 8 * 5 * 9 * 2, 8 * 5 * 9 * 7);
    CAPTURE(bytes);
    IcReply whole;
    whole.table = IcTable(nx, ny);
    for (const IcPart& part : parts_within(frames_of(bytes), nx, ny)) {
        CHECK_NOTHROW(check_size(part, nx, frames_of(bytes)));
        ArrayWriter arrays(ArrayEncoding::frame);
        const auto result = encode_ic_part_reply(reply, decode_ic_part(encode_ic_part(part), ny), arrays);
        const auto frames = arrays.take_frames();
        CHECK(violations_of("ic.get.result", result).empty());
        CHECK(frames[0].size() <= bytes);
        read_part(result, frames, part, whole);
    }
    CHECK(whole.table.values == reply.table.values);
    CHECK(whole.key == "key");
}

TEST_CASE("Parts of different tables do not make one", "[ic_part]") {
    IcReply reply = counting_reply(2, 2), whole;
    whole.table = IcTable(2, 2);
    const IcPart part{0, 2, {8}, false};
    const auto read = [&] {
        ArrayWriter arrays(ArrayEncoding::list);
        read_part(encode_ic_part_reply(reply, part, arrays), {}, part, whole);
    };
    read();
    reply.key = "another";
    CHECK(wire::status_thrown_by(read)->violations[0].field == "key");
}

TEST_CASE("A part that is too large is refused with what to ask for", "[ic_part]") {
    const IcPart all{0, 100, {}, true};
    const auto says = [&](std::size_t bytes) {
        const auto status = wire::status_thrown_by([&] { check_size(all, 10, frames_of(bytes)); });
        REQUIRE(status);
        CHECK(status->reason == "ANSWER_TOO_LARGE");
        CHECK(status->violations[0].field == "rows");
        return status->message;
    };
    CHECK_FALSE(wire::status_thrown_by([&] { check_size(all, 10, frames_of(72'000)); }));
    CHECK_THAT(says(71'999), ContainsSubstring("at most 99 at a time"));
    CHECK_THAT(says(500), ContainsSubstring("one row and at most 6 of the components"));
    CHECK_THAT(says(79), ContainsSubstring("a single component"));
}
