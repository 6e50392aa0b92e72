#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <limits>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using nlohmann::json;

namespace {

IcSpec fem_spec() {
    IcSpec spec;
    spec.material = {82000.1, 0.1 + 0.2};
    spec.dx = 0.1;
    spec.dy = 1.0 / 3;
    spec.nx = 2;
    spec.ny = 3;
    spec.source = IcSource::fem;
    spec.fem.order = 1;
    spec.fem.l_over_h = 2.5;
    spec.fem.h_over_hs = 6;
    spec.fem.f = 1.7;
    spec.fem.L_over_h = 12.5;
    spec.fem.sampling = Sampling::linear;
    spec.fem.tolerance = 1e-11;
    spec.fem.max_iterations = 77;
    spec.fem.strength_threshold = 0.6;
    return spec;
}

IcReply ic_reply() {
    IcReply reply;
    reply.key = std::string(64, 'a');
    reply.origin = "built";
    reply.spec = fem_spec();
    reply.table = IcTable(2, 3);
    for (std::size_t i = 0; i < reply.table.values.size(); ++i)
        reply.table.values[i] = 1.0 / (static_cast<double>(i) - 7.3);
    IcEvidence& evidence = reply.evidence;
    evidence.source = "fem";
    evidence.version = "contactd 0.1.0";
    evidence.elements = 1840;
    evidence.dofs = 5'000'000'000;
    evidence.processes = 2;
    evidence.assembly_seconds = 0.1;
    evidence.setup_seconds = 0.2;
    evidence.solve_seconds = 0.3;
    evidence.total_seconds = 0.6;
    evidence.load_cases = {{Axis::z, 13, 3e-9, true, 0.1}, {Axis::x, 14, 4e-9, false, 0.2}};
    evidence.error_zz = ComponentError{-1.2e-3, 1.4e-2};
    evidence.scaled_error_xy = 2e-4;
    return reply;
}

void check_equal(const IcEvidence& a, const IcEvidence& b) {
    CHECK(encode_evidence(a) == encode_evidence(b));
    CHECK(a.dofs == b.dofs);
    CHECK(a.load_cases.size() == b.load_cases.size());
    CHECK(a.error_zz.has_value() == b.error_zz.has_value());
    CHECK(a.error_xx.has_value() == b.error_xx.has_value());
    CHECK(a.scaled_error_xy == b.scaled_error_xy);
}

/// As it arrives: through text.
json sent(const json& message) {
    return json::parse(dump(message));
}

}  // namespace

TEST_CASE("An IC spec comes back exactly", "[codec]") {
    IcSpec spec = fem_spec();
    SECTION("finite elements") {}
    SECTION("closed form") {
        spec.source = IcSource::analytic;
        spec.fem = {};
    }
    const json params = encode_ic_spec(spec);

    CHECK(violations_of("ic.get.params", params).empty());
    CHECK(decode_ic_spec(sent(params)) == spec);
}

TEST_CASE("A preset sets the paper's choices and named fields win over it", "[codec]") {
    const IcSpec spec = decode_ic_spec(wire::ic_params());

    FemSpec expected = *fem_preset("paper-test2");
    expected.L_over_h = 1280;
    CHECK(spec.fem == expected);
    CHECK(spec.ny == 12);
    CHECK(spec.dy == 0.4);
}

TEST_CASE("Without a preset finite elements have their defaults", "[codec]") {
    json params = wire::ic_params();
    params["ics"] = {{"source", "fem"}};
    CHECK(decode_ic_spec(params).fem == FemSpec{});
}

TEST_CASE("The reply of ic.get comes back exactly", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    const IcReply reply = ic_reply();
    ArrayWriter arrays(encoding);
    const json result = encode_ic_reply(reply, arrays);

    CHECK(violations_of("ic.get.result", result).empty());
    const IcReply read = decode_ic_reply(sent(result), arrays.take_frames());

    CHECK(read.key == reply.key);
    CHECK(read.origin == "built");
    CHECK(read.spec == reply.spec);
    CHECK(read.table.nx == 2);
    CHECK(read.table.ny == 3);
    CHECK(read.table.values == reply.table.values);
    check_equal(read.evidence, reply.evidence);
}

TEST_CASE("A table of another extent than its spec is refused", "[codec]") {
    ArrayWriter arrays(ArrayEncoding::frame);
    json result = encode_ic_reply(ic_reply(), arrays);
    result["spec"]["grid"]["nx"] = 3;
    CHECK(wire::status_thrown_by([&] { decode_ic_reply(result, arrays.take_frames()); }));
}

TEST_CASE("Evidence that is not finite is not sent", "[codec]") {
    IcEvidence evidence = ic_reply().evidence;
    evidence.load_cases[0].residual = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(encode_evidence(evidence), Error);
}
