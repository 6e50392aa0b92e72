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
    spec.load_shape = LoadShape::bilinear;
    spec.fem.mesh = MeshKind::prism;
    spec.fem.order = 1;
    spec.fem.l_over_h = 2.5;
    spec.fem.h_over_hs = 6;
    spec.fem.f = 1.7;
    spec.fem.t1_over_hs = 0.3;
    spec.fem.L_over_h = 12.5;
    spec.fem.diagonal = Diagonal::across;
    spec.fem.max_dofs = 4'000'000;
    spec.fem.far_boundary = FarBoundary::clamped;
    spec.fem.sampling = Sampling::linear;
    spec.fem.solver = Solver::amg_pcg;
    spec.fem.stopping_criterion = StoppingCriterion::update;
    spec.fem.tolerance = 1e-11;
    spec.fem.max_iterations = 77;
    spec.fem.strength_threshold = 0.6;
    return spec;
}

/// Returns the spec requested by `ics`, which its schema must accept.
IcSpec asked_by(const json& ics) {
    json params = wire::ic_params();
    params["ics"] = ics;
    REQUIRE(violations_of("ic.get.params", params).empty());
    return decode_ic_spec(params);
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
    evidence.seconds.assembly = 0.1;
    evidence.seconds.setup = 0.2;
    evidence.seconds.solve = 0.3;
    evidence.seconds.total = 0.6;
    evidence.load_cases = {{Axis::z, 13, 3e-9, true, 0.1, {}}, {Axis::x, 14, 4e-9, false, 0.2, 1e-9}};
    evidence.solver = "direct";
    evidence.warnings = {"f is 1.7; the paper advises 1 to 1.5 on Mesh1 (Table 3)."};
    evidence.mesh = fem_spec().fem;
    evidence.errors.zz = ComponentError{-1.2e-3, 1.4e-2};
    evidence.errors.scaled_xy = 2e-4;
    evidence.errors_estimated = true;
    evidence.family_nu = {0, 0.245, 0.49};
    evidence.interpolation_error = 3e-6;
    evidence.modelling_error = 0.07;
    return reply;
}

void check_equal(const IcEvidence& a, const IcEvidence& b) {
    CHECK(encode_evidence(a) == encode_evidence(b));
    CHECK(a.dofs == b.dofs);
    CHECK(a.load_cases.size() == b.load_cases.size());
    CHECK(a.errors.zz.has_value() == b.errors.zz.has_value());
    CHECK(a.errors.xx.has_value() == b.errors.xx.has_value());
    CHECK(a.errors.scaled_xy == b.errors.scaled_xy);
    CHECK(a.load_cases[0].update == b.load_cases[0].update);
    CHECK(a.load_cases[1].update == b.load_cases[1].update);
    CHECK(a.solver == b.solver);
    CHECK(a.warnings == b.warnings);
    CHECK(a.mesh == b.mesh);
    CHECK(a.errors_estimated == b.errors_estimated);
    CHECK(a.family_nu == b.family_nu);
    CHECK(a.interpolation_error == b.interpolation_error);
    CHECK(a.modelling_error == b.modelling_error);
}

/// Returns the message as received, through text.
json sent(const json& message) {
    return json::parse(dump(message));
}

}  // namespace

TEST_CASE("An IC spec comes back exactly", "[codec]") {
    IcSpec spec = fem_spec();
    SECTION("finite elements") {}
    SECTION("a threshold chosen for the mesh") {
        spec.fem.strength_threshold.reset();
    }
    SECTION("a family of a block") {
        spec.body = BodyShape::block;
        spec.any_nu = true;
    }
    SECTION("an accuracy") {
        spec.accuracy = 1e-2;
        spec.any_nu = true;
        spec.fem = {};
    }
    SECTION("an accuracy of a block") {
        spec.accuracy = 1e-4;
        spec.body = BodyShape::block;
        spec.fem = {};
        spec.fem.L_over_h = 17;
    }
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

TEST_CASE("A preset clamps the far faces, a mesh without one has the displacements of the half-space there",
          "[codec]") {
    CHECK(asked_by({{"source", "fem"}, {"preset", "paper-mesh2-test1"}}).fem == *fem_preset("paper-mesh2-test1"));
    CHECK(asked_by({{"source", "fem"}, {"preset", "paper-test3"}}).fem.far_boundary == FarBoundary::clamped);
    CHECK(asked_by({{"source", "fem"}, {"order", 2}}).fem == FemSpec{});
    FemSpec open = *fem_preset("paper-test3");
    open.far_boundary = FarBoundary::half_space;
    CHECK(asked_by({{"source", "fem"}, {"preset", "paper-test3"}, {"far_boundary", "half_space"}}).fem == open);
}

TEST_CASE("A block is clamped, with and without a preset", "[codec]") {
    FemSpec clamped;
    clamped.far_boundary = FarBoundary::clamped;
    CHECK(asked_by({{"source", "fem"}, {"body", "block"}, {"order", 2}}).fem == clamped);
    CHECK(asked_by({{"source", "fem"}, {"body", "block"}, {"preset", "paper-test3"}}).fem ==
          *fem_preset("paper-test3"));
}

TEST_CASE("Finite elements without a mesh are asked for an accuracy of 1e-3", "[codec]") {
    IcSpec expected = asked_by({{"source", "fem"}, {"accuracy", 1e-3}});
    REQUIRE(expected.accuracy == 1e-3);
    REQUIRE(expected.fem == FemSpec{});

    CHECK(asked_by({{"source", "fem"}}) == expected);
    CHECK(asked_by({{"source", "fem"}, {"body", "half_space"}, {"load_shape", "constant"}}) == expected);

    expected.any_nu = true;
    CHECK(asked_by({{"source", "fem"}, {"any_nu", true}}) == expected);
}

TEST_CASE("Any field of a mesh or a solver names a mesh", "[codec]") {
    const json all = encode_ic_spec(fem_spec())["ics"];
    for (const auto& member : all.items()) {
        CAPTURE(member.key());
        const bool of_the_table = member.key() == "source" || member.key() == "body" || member.key() == "load_shape" ||
                                  member.key() == "any_nu";
        CHECK((asked_by({{"source", "fem"}, {member.key(), member.value()}}).accuracy == 0) == !of_the_table);
    }
}

TEST_CASE("The size of a block belongs to the body, so it goes with an accuracy", "[codec]") {
    const IcSpec spec = asked_by({{"source", "fem"}, {"body", "block"}, {"L_over_h", 30}});
    CHECK(spec.accuracy == 1e-3);
    CHECK(spec.fem.L_over_h == 30);
    CHECK(asked_by({{"source", "fem"}, {"body", "block"}, {"L_over_h", 30}, {"f", 1.5}}).accuracy == 0);
    CHECK(asked_by({{"source", "fem"}, {"L_over_h", 30}}).accuracy == 0);
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

TEST_CASE("A reply of ic.get without the material of its body is refused", "[codec]") {
    ArrayWriter arrays(ArrayEncoding::list);
    json result = encode_ic_reply(ic_reply(), arrays);
    result["spec"].erase("material");
    CHECK(violations_of("ic.get.result", result).empty());
    CHECK_THROWS_AS(decode_ic_reply(result, {}), StatusError);
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

TEST_CASE("Evidence of a closed form speaks of no build", "[codec]") {
    IcEvidence evidence;
    evidence.source = "analytic";
    evidence.version = "contactd 0.1.0";
    const json message = sent(encode_evidence(evidence));
    CHECK(message == json{{"source", "analytic"}, {"version", "contactd 0.1.0"}});
    const IcEvidence read = decode_evidence(message);
    CHECK(read.elements == 0);
    CHECK(read.load_cases.empty());
    CHECK_FALSE(read.errors.zz);
}

TEST_CASE("Evidence of a daemon that knows less is read", "[codec]") {
    json evidence = encode_evidence(ic_reply().evidence);
    for (const char* name : {"solver", "warnings", "mesh", "errors_estimated", "family_nu", "interpolation_error"})
        evidence.erase(name);
    const IcEvidence read = decode_evidence(evidence);
    CHECK(read.solver.empty());
    CHECK(read.warnings.empty());
    CHECK_FALSE(read.mesh);
    CHECK(read.dofs == 5'000'000'000);
}
