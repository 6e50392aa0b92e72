#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <vector>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "wire.hpp"

using namespace contactd::proto;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

struct Case {
    const char* pointer;  ///< what is set
    const char* value;    ///< JSON
    const char* field;    ///< the field that the answer names
    const char* says;
};

/// Sets one value and expects exactly one violation.
void check_case(const std::string& method, json params, const Case& c) {
    CAPTURE(c.pointer, c.value);
    params[json::json_pointer(c.pointer)] = json::parse(c.value);
    const auto status = wire::status_thrown_by([&] { check_params(method, params); });
    REQUIRE(status);
    CHECK(status->code == StatusCode::invalid_argument);
    REQUIRE(status->violations.size() == 1);
    CHECK(status->violations[0].field == c.field);
    CHECK_THAT(status->violations[0].description, ContainsSubstring(c.says));
    CHECK_THAT(status->message, ContainsSubstring(c.field) && ContainsSubstring(c.says));
}

}  // namespace

TEST_CASE("Every method has schemas, and every message one", "[schema]") {
    for (const std::string& method : method_names()) {
        CAPTURE(method);
        CHECK(schema(method + ".params")["type"] == "object");
        CHECK(schema(method + ".result")["type"] == "object");
    }
    for (const char* name : {"envelope", "reply", "progress"}) CHECK(schema(name)["additionalProperties"] == false);
    CHECK_THROWS_AS(schema("no.such"), std::out_of_range);
}

TEST_CASE("Schemas stand alone and describe every field", "[schema]") {
    const std::function<void(const json&, const std::string&)> visit = [&](const json& node, const std::string& path) {
        CAPTURE(path);
        CHECK_FALSE(node.contains("$ref"));
        if (!node.contains("properties")) return;
        for (const auto& property : node["properties"].items()) {
            CHECK(property.value().contains("description"));
            // A title describes in words a pattern for programs.
            CHECK(property.value().contains("pattern") <= property.value().contains("title"));
            visit(property.value(), path + "." + property.key());
        }
        CHECK(node.contains("additionalProperties"));
    };
    for (const std::string& method : method_names())
        for (const char* part : {".params", ".result"}) visit(schema(method + part), method + part);
}

TEST_CASE("Good parameters pass", "[schema]") {
    CHECK_NOTHROW(check_params("ic.get", wire::ic_params()));
    CHECK_NOTHROW(check_params("contact.solve", wire::solve_params()));
    CHECK_NOTHROW(check_params("contact.solve_many", {{"problems", json(3, wire::solve_params())}}));
    CHECK_NOTHROW(check_params("job.cancel", {{"job", "build-3"}}));
    for (const char* method : {"server.info", "server.health", "server.describe", "server.metrics", "job.list"})
        CHECK_NOTHROW(check_params(method, json::object()));
}

TEST_CASE("An unknown method is UNIMPLEMENTED", "[schema]") {
    for (const std::string method : {"", "contact", "contact.solve.params", "envelope", "server.restart"}) {
        const auto status = wire::status_thrown_by([&] { check_params(method, json::object()); });
        REQUIRE(status);
        CHECK(status->code == StatusCode::unimplemented);
        CHECK(status->reason == "UNKNOWN_METHOD");
        CHECK_THAT(status->message, ContainsSubstring("\"" + method + "\"") && ContainsSubstring("contact.solve"));
    }
}

TEST_CASE("A bad value of ic.get is named with what would be right", "[schema]") {
    check_case(
        "ic.get", wire::ic_params(),
        GENERATE(
            Case{"/grid/nx", "-1", "grid.nx", "is -1; it must be at least 1"},
            Case{"/grid/nx", "0", "grid.nx", "is 0; it must be at least 1"},
            Case{"/grid/nx", "1.5", "grid.nx", "is 1.5; it must be an integer from 1"},
            Case{"/grid/nx", "1e30", "grid.nx", "it must be an integer"},
            Case{"/grid/nx", "\"10\"", "grid.nx", "is \"10\"; it must be an integer"},
            Case{"/grid/nx", "null", "grid.nx", "is null"}, Case{"/grid/nx", "true", "grid.nx", "is true"},
            Case{"/grid/dx", "0", "grid.dx", "is 0; it must be positive"},
            Case{"/grid/dx", "-0.8", "grid.dx", "is -0.8; it must be positive"},
            Case{"/grid/dx", "1e300", "grid.dx", "it must lie in (0, 1000000000000]"},
            Case{"/grid/dy", "[0.8]", "grid.dy", "is a list with 1 value; it must be a number"},
            Case{"/grid/dz", "1", "grid.dz", "is not a field of grid; known fields are dx, dy, nx, ny"},
            Case{"/grid", "3", "grid", "is 3; it must be an object with dx, dy, nx, ny"},
            Case{"/material/nu", "0.51", "material.nu", "is 0.51; it must lie in [0, 0.5]"},
            Case{"/material/nu", "-0.1", "material.nu", "is -0.1; it must lie in [0, 0.5]"},
            Case{"/material/G", "0", "material.G", "is 0; it must be positive"},
            Case{"/material/G", "\"stiff\"", "material.G", "is \"stiff\"; it must be a number"},
            Case{"/material/E", "210000", "material.E", "is not a field of material; known fields are G, nu"},
            Case{"/ics/source", "\"magic\"", "ics.source", "is \"magic\"; it must be one of \"analytic\", \"fem\""},
            Case{"/ics/order", "7", "ics.order", "is 7; it must be at most 6"},
            Case{"/ics/order", "0", "ics.order", "is 0; it must be at least 1"},
            Case{"/ics/order", "\"2\"", "ics.order", "it must be an integer from 1 to 6"},
            Case{"/ics/mesh", "\"tet\"", "ics.mesh", "it must be one of \"hex\", \"prism\", \"adaptive\""},
            Case{"/ics/body", "\"rail\"", "ics.body", "it must be one of \"half_space\", \"block\""},
            Case{"/ics/load_shape", "\"cubic\"", "ics.load_shape", "one of \"constant\", \"bilinear\""},
            Case{"/ics/diagonal", "\"up\"", "ics.diagonal", "one of \"outward\", \"across\""},
            Case{"/ics/far_boundary", "\"free\"", "ics.far_boundary", "one of \"clamped\", \"half_space\""},
            Case{"/ics/solver", "\"lu\"", "ics.solver", "one of \"auto\", \"amg_pcg\", \"direct\""},
            Case{"/ics/solver", "\"dirct\"", "ics.solver", "\"direct\". Did you mean \"direct\"?"},
            Case{"/ics/stopping_criterion", "\"energy\"", "ics.stopping_criterion", "one of \"residual\", \"update\""},
            Case{"/ics/t1_over_hs", "-1", "ics.t1_over_hs", "it must lie in [0, 1000]"},
            Case{"/ics/max_dofs", "10", "ics.max_dofs", "it must be at least 1000"},
            Case{"/ics/any_nu", "1", "ics.any_nu", "is 1; it must be true or false"},
            Case{"/ics/preset", "\"paper-test4\"", "ics.preset", "one of \"paper-test1\""},
            Case{"/ics/f", "0.5", "ics.f", "is 0.5; it must lie in [1, 10]"},
            Case{"/ics/h_over_hs", "1", "ics.h_over_hs", "is 1"},
            Case{"/ics/L_over_h", "0", "ics.L_over_h", "is 0; it must be positive"},
            Case{"/ics/tolerance", "1", "ics.tolerance", "is 1; it must lie in [1e-13, 1)"},
            Case{"/ics/max_iterations", "0", "ics.max_iterations", "is 0; it must be at least 1"},
            Case{"/ics/strength_threshold", "-1", "ics.strength_threshold", "is -1; it must lie in [0, 1)"},
            Case{"/ics/colour", "\"red\"", "ics.colour", "is not a field of ics; known fields are"},
            Case{"/ics/stop_test", "\"update\"", "ics.stop_test",
                 "is not a field of ics, but stopping_criterion is; known"},
            Case{"/ics/tolerence", "1", "ics.tolerence", "is not a field of ics, but tolerance is; known fields are"},
            Case{"/ics/sourc", "1", "ics.sourc", "is not a field of ics, but source is; known fields are"},
            Case{"/extra", "{}", "extra",
                 "is not a field of ic.get; known fields are components, grid, ics, material, rows"}));
}

TEST_CASE("A key that is none is named with what would be right", "[schema]") {
    const json good{{"key", std::string(64, 'a')}};
    CHECK_NOTHROW(check_params("ic.delete", good));
    const char* says = "it must be a key, 64 hexadecimal digits in lower case";
    check_case("ic.delete", good, {"/key", R"("4F1C")", "key", says});
    check_case("ic.delete", good, {"/key", ('"' + std::string(100000, 'a') + '"').c_str(), "key", says});
}

TEST_CASE("A bad value of contact.solve is named with what would be right", "[schema]") {
    check_case(
        "contact.solve", wire::solve_params(),
        GENERATE(
            Case{"/bodies/upper/nu", "0.6", "bodies.upper.nu", "is 0.6; it must lie in [0, 0.5]"},
            Case{"/bodies/lower", "{\"G\": 1}", "bodies.lower.nu", "is missing; it must be a number"},
            Case{"/bodies/middle", "{}", "bodies.middle", "known fields are lower, upper"},
            Case{"/bodies/lower", "5", "bodies.lower",
                 "must be a material, an object with G and nu, or {\"rigid\": true}"},
            Case{"/bodies/lower", "{\"rigid\": false}", "bodies.lower.rigid", "is false; it must be true"},
            Case{"/bodies/lower", "{\"rigid\": true, \"nu\": 0.3}", "bodies.lower.nu",
                 "cannot be combined with rigid, which allows only rigid: a rigid body has no material"},
            Case{"/gap", "{}", "gap", "it must contain exactly one of array, half_ellipses, paraboloid, semi_axes"},
            Case{"/gap", "{\"semi_axes\": {\"a\": 1}}", "gap.semi_axes.b", "is missing; it must be a number"},
            Case{"/gap", "{\"semi_axes\": {\"a\": 1, \"b\": 0}}", "gap.semi_axes.b", "is 0; it must be positive"},
            Case{"/gap/array", "[[1,2,3],[4,5,6]]", "gap", "is an object with 2 fields; it must contain exactly one"},
            Case{"/gap", "{\"array\": 5}", "gap.array", "is 5; it must be a list of numbers or {\"$array\""},
            Case{"/gap/paraboloid", "{}", "gap.paraboloid", "it must contain at least one of Rx, Ry"},
            Case{"/gap/paraboloid/Rx", "0", "gap.paraboloid.Rx", "is 0; it must not be 0"},
            Case{"/gap/paraboloid/Rx", "-0.0", "gap.paraboloid.Rx", "it must not be"},
            Case{"/gap/paraboloid/Rz", "5", "gap.paraboloid.Rz", "known fields are Rx, Ry"},
            Case{"/approach", "\"deep\"", "approach", "is \"deep\"; it must be a number"},
            Case{"/Fn", "9.2", "Fn", "cannot be combined with approach; remove one of them"},
            Case{"/Fn", "-1", "Fn", "is -1; it must lie in [0, 1000000000000000000]"},
            Case{"/model", "\"exact\"", "model", "it must be one of \"full\", \"hertz\", \"fastsim\""},
            Case{"/friction/mu", "\"high\"", "friction.mu",
                 "is \"high\"; it must be a number, a list of numbers or {\"$array\": ...}"},
            Case{"/friction/mu", "{}", "friction.mu.$array", "is missing"},
            Case{"/friction/rolling", "{}", "friction.rigid_shift",
                 "cannot be combined with rolling, which allows only mu, kinetic, layer, temperature, rolling"},
            Case{"/friction/rotation", "null", "friction.rotation", "is null; it must be a number"},
            Case{"/friction/duration", "0", "friction.duration", "is 0; it must be positive"},
            Case{"/friction/force", "[1]", "friction.force", "has 1 values; it must have 2"},
            Case{"/friction/force", "[null, null]", "friction.force",
                 "has no value that is a number; it must have at least one"},
            Case{"/friction/force", "[\"1\", 2]", "friction.force[0]", "is \"1\"; it must be a number or null"},
            Case{"/friction/kinetic", "{\"mu\": 0.1}", "friction.kinetic.slip_velocity",
                 "is missing; it must be a number"},
            Case{"/friction/kinetic", R"({"mu": 0.1, "slip_velocity": 1, "law": "cubic"})", "friction.kinetic.law",
                 "it must be one of \"linear\", \"exponential\", \"rational\""},
            Case{"/previous", "{\"pressures\": []}", "previous.pressures",
                 "known fields are friction_coefficient, pressure, traction_x, traction_y, yield_stress"},
            Case{"/previous", "{\"pressure\": 1}", "previous.pressure", "is 1; it must be a list of numbers"},
            Case{"/friction/mu", "-0.1", "friction.mu", "is -0.1; it must lie in [0, 1000]"},
            Case{"/friction", "{\"mu\": 0.4}", "friction.rigid_shift",
                 "is missing; it must be a list of 2 values, unless force or rolling or rigid_slip is given"},
            Case{"/friction/rigid_shift", "[1]", "friction.rigid_shift", "has 1 values; it must have 2"},
            Case{"/friction/rigid_shift", "[1, 2, 3]", "friction.rigid_shift", "has 3 values; it must have 2"},
            Case{"/friction/rigid_shift", "[1, \"2\"]", "friction.rigid_shift[1]", "is \"2\"; it must be a number"},
            Case{"/settings", "{\"normal\": {\"tolerance\": 0}}", "settings.normal.tolerance", "it must be positive"},
            Case{"/settings", "{\"norm\": {}}", "settings.norm", "known fields are normal, outer, tangential"},
            Case{"/settings", "{\"outer\": {\"max_iterations\": 0}}", "settings.outer.max_iterations", "at least 1"},
            Case{"/initial", "{\"pressure\": null}", "initial.pressure", "is null"},
            Case{"/ics/order", "2", "ics.order",
                 "cannot be combined with source \"analytic\", which allows only source, body, load_shape, layers, "
                 "base, "
                 "line_contact, section"}));
}

TEST_CASE("A bad value of rolling is named with what would be right", "[schema]") {
    json params = wire::solve_params();
    params["friction"] = {{"mu", 0.3}, {"rolling", json::object()}};
    check_case(
        "contact.solve", params,
        GENERATE(
            Case{"/friction/rolling/xi", "\"1\"", "friction.rolling.xi", "is \"1\"; it must be a number"},
            Case{"/friction/rolling/spin", "1", "friction.rolling.spin",
                 "known fields are chi, dq, eta, force, kind, phi, spin_offset, steps, velocity, xi"},
            Case{"/friction/rolling/dq", "0", "friction.rolling.dq", "is 0; it must be positive"},
            Case{"/friction/rolling/spin_offset", "1.5", "friction.rolling.spin_offset",
                 "is 1.5; it must lie in [0, 1]"},
            Case{"/friction/rolling/kind", "\"slow\"", "friction.rolling.kind", "one of \"steady\", \"transient\""},
            Case{"/friction/rolling/steps", "100001", "friction.rolling.steps", "it must be at most 100000"},
            Case{"/friction/rolling/velocity", "-1", "friction.rolling.velocity", "is -1; it must be positive"},
            Case{"/friction/rolling/force", "[1e19, 0]", "friction.rolling.force[0]", "it must lie in"},
            Case{"/friction/force", "[1, 2]", "friction.force",
                 "cannot be combined with rolling, which allows only mu, kinetic, layer, temperature, rolling, "
                 "rigid_slip: creepages and forces of rolling"},
            Case{"/friction/duration", "2", "friction.duration", "cannot be combined with rolling"}));
}

TEST_CASE("The full model needs coefficients, the quick ones need bodies only", "[schema]") {
    json params = wire::solve_params();
    params.erase("ics");
    const auto missing = violations_of("contact.solve.params", params);
    REQUIRE(missing.size() == 1);
    CHECK(missing[0].field == "ics");
    CHECK_THAT(missing[0].description, ContainsSubstring("is missing; it must be an object with source"));
    for (const char* model : {"hertz", "fastsim", "fastrip", "polach"}) {
        params["model"] = model;
        CHECK_NOTHROW(check_params("contact.solve", params));
        json without = params;
        without.erase("bodies");
        REQUIRE(violations_of("contact.solve.params", without).size() == 1);
        CHECK(violations_of("contact.solve.params", without)[0].field == "bodies");
        params["ics"] = {{"source", "analytic"}};
        CHECK_NOTHROW(check_params("contact.solve", params));
        params.erase("ics");
    }
}

TEST_CASE("Either the approach or the force is given", "[schema]") {
    json params = wire::solve_params();
    params.erase("approach");
    const auto missing = violations_of("contact.solve.params", params);
    REQUIRE(missing.size() == 1);
    CHECK(missing[0].field == "approach");
    CHECK(missing[0].description == "is missing; it must be a number, unless Fn is given");
    params["Fn"] = 0;
    CHECK_NOTHROW(check_params("contact.solve", params));
}

TEST_CASE("A bad list of problems is named with what would be right", "[schema]") {
    check_case("contact.solve_many", {{"problems", json::array({wire::solve_params()})}},
               GENERATE(Case{"/problems", "[]", "problems", "has 0 values; it must have at least 1"},
                        Case{"/problems", "{}", "problems", "it must be a list"},
                        Case{"/problems/0", "5", "problems[0]",
                             "is 5; it must be an object with the parameters of contact.solve"},
                        Case{"/problems/0/approach", "null", "problems[0].approach", "is null; it must be a number"},
                        Case{"/problems/0/aproach", "1", "problems[0].aproach", "is not a field of problems[0]"},
                        Case{"/timeout", "1", "timeout", "is not a field of contact.solve_many"}));
    const auto many = violations_of("contact.solve_many.params", {{"problems", json(1001, wire::solve_params())}});
    REQUIRE(many.size() == 1);
    CHECK(many[0].description == "has 1001 values; it must have at most 1000");
}

TEST_CASE("What a request for an accuracy cannot hold is named, with the reason", "[schema]") {
    const char* mesh = "an accuracy chooses the mesh and the solver by itself";
    const auto refused = [](const char* ics) {
        json params = wire::ic_params();
        params["ics"] = json::parse(ics);
        return violations_of("ic.get.params", params);
    };
    for (const char* field : {R"("preset": "paper-test3")", R"("mesh": "hex")", R"("order": 2)", R"("l_over_h": 1)",
                              R"("h_over_hs": 4)", R"("f": 1.2)", R"("t1_over_hs": 1)", R"("L_over_h": 640)",
                              R"("diagonal": "across")", R"("max_dofs": 2000)", R"("far_boundary": "clamped")",
                              R"("sampling": "fem")", R"("solver": "auto")", R"("stopping_criterion": "update")",
                              R"("tolerance": 1e-8)", R"("max_iterations": 9)", R"("strength_threshold": 0.5)"}) {
        CAPTURE(field);
        const auto found = refused((R"({"source": "fem", "accuracy": 1e-3, )" + std::string(field) + "}").c_str());
        REQUIRE(found.size() == 1);
        CHECK(R"("ics.)" + std::string(field).substr(1, std::string(field).find(':') - 2) == '"' + found[0].field);
        CHECK_THAT(found[0].description,
                   ContainsSubstring("cannot be combined with accuracy") && ContainsSubstring(mesh));
    }
    CHECK(refused(R"({"source": "fem", "accuracy": 1e-3, "body": "block", "L_over_h": 20})").empty());
    CHECK(refused(R"({"source": "fem", "accuracy": 1e-3, "load_shape": "bilinear", "any_nu": true})").empty());
    CHECK(refused(R"({"source": "fem", "accuracy": 1e-3, "body": "block", "L_over_h": 20, "f": 2})").size() == 1);
    CHECK(refused(R"({"source": "fem", "accuracy": 1e-3, "order": 3, "f": 2})").size() == 2);
}

TEST_CASE("An accuracy is 1e-4 to 0.1 and goes with finite elements", "[schema]") {
    check_case("ic.get",
               {{"material", {{"G", 1}, {"nu", 0}}},
                {"grid", {{"nx", 1}, {"ny", 1}, {"dx", 1}, {"dy", 1}}},
                {"ics", {{"source", "fem"}}}},
               GENERATE(Case{"/ics/accuracy", "1e-5", "ics.accuracy", "it must lie in [0.0001, 0.1]"},
                        Case{"/ics/accuracy", "1", "ics.accuracy", "is 1; it must lie in [0.0001, 0.1]"},
                        Case{"/ics/accuracy", "\"high\"", "ics.accuracy", "it must be a number"},
                        Case{"/ics", R"({"source": "analytic", "accuracy": 1e-3})", "ics.accuracy",
                             "cannot be combined with source \"analytic\""},
                        Case{"/ics", R"({"source": "analytic", "any_nu": true})", "ics.any_nu",
                             "cannot be combined with source \"analytic\""}));
}

TEST_CASE("A bad reference to a frame is ARRAY_INVALID", "[schema]") {
    const char* gap =
        GENERATE(R"({"frame": 0, "dtype": "<f8", "shape": [2, 3]})", R"({"frame": 1, "dtype": "f4", "shape": [2, 3]})",
                 R"({"frame": 1, "dtype": "<f8", "shape": []})", R"({"frame": 1, "dtype": "<f8"})",
                 R"({"frame": 1, "dtype": "<f8", "shape": [2, 3], "order": "F"})");
    json params = wire::solve_params();
    params["gap"] = {{"array", {{"$array", json::parse(gap)}}}};

    const auto status = wire::status_thrown_by([&] { check_params("contact.solve", params); });

    REQUIRE(status);
    CHECK(status->reason == "ARRAY_INVALID");
    CHECK(status->violations[0].field.starts_with("gap.array.$array"));
}

TEST_CASE("Everything that is missing is named", "[schema]") {
    const auto status = wire::status_thrown_by([] { check_params("contact.solve", {{"grid", {{"nx", 3}}}}); });

    REQUIRE(status);
    CHECK(status->reason == "FIELD_INVALID");
    std::vector<std::string> fields;
    for (const Violation& violation : status->violations) {
        CHECK_THAT(violation.description, ContainsSubstring("is missing; it must be "));
        fields.push_back(violation.field);
    }
    std::sort(fields.begin(), fields.end());
    CHECK(fields == std::vector<std::string>{"approach", "bodies", "gap", "grid.dx", "grid.dy", "grid.ny", "ics"});
}

TEST_CASE("Violations are bounded and their quotations short", "[schema]") {
    json params = wire::ic_params();
    for (int i = 0; i < 1000; ++i) params[std::string(500, 'x') + std::to_string(i)] = i;
    params["material"]["G"] = std::string(100'000, 'g');

    const auto status = wire::status_thrown_by([&] { check_params("ic.get", params); });

    REQUIRE(status);
    CHECK(status->violations.size() <= 20);
    CHECK(status->message.size() < 5000);
}

TEST_CASE("Numbers at the edge of the types are answered", "[schema]") {
    json params = wire::ic_params();
    for (const char* number : {"9223372036854775807", "-9223372036854775808", "1e18", "-1e300", "4000001"}) {
        CAPTURE(number);
        params["grid"]["nx"] = json::parse(number);
        const auto status = wire::status_thrown_by([&] {
            check_params("ic.get", params);
            decode_ic_spec(params);
        });
        REQUIRE(status);
        REQUIRE(status->violations.size() == 1);
        CHECK(status->violations[0].field == "grid.nx");
    }
}

TEST_CASE("Schemas can be used from several threads", "[schema]") {
    std::vector<std::size_t> found(4);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < found.size(); ++t)
        threads.emplace_back([&found, t] {
            json params = wire::ic_params();
            params["grid"]["nx"] = -1;
            for (int i = 0; i < 200; ++i) found[t] += violations_of("ic.get.params", params).size();
        });
    for (std::thread& thread : threads) thread.join();
    CHECK(found == std::vector<std::size_t>(4, 200));
}

TEST_CASE("A schema of one's own can be used", "[schema]") {
    const json own = json::parse(R"({"title": "the file", "type": "object", "additionalProperties": false,
        "properties": {"port": {"type": "integer", "minimum": 1, "maximum": 65535}}})");
    CHECK(violations_against(own, {{"port", 80}}).empty());
    REQUIRE(violations_against(own, {{"port", 0}}).size() == 1);
    CHECK(violations_against(own, {{"prot", 1}})[0].description ==
          "is not a field of the file, but port is; known fields are port");
}
