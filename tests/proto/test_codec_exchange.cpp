// Tests ic.export, and contact.solve with provided coefficients.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/import_codec.hpp"
#include "contactd/proto/schema.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

/// Returns values that an elastic pair may have, largest at (0, 0).
GivenIcs given(int nx = 3, int ny = 2) {
    GivenIcs ics{IcTable(nx, ny), 0.06, 0.06};
    for (std::size_t n = 0; n < ics.table.values.size(); ++n) ics.table.values[n] = 1e-3 / (1 + static_cast<double>(n));
    for (const Axis i : {Axis::x, Axis::y, Axis::z}) ics.table(i, i, 0, 0) = 1;
    return ics;
}

ContactProblem problem(const GivenIcs& ics) {
    ContactProblem problem;
    problem.grid = Grid::of_elements(3, 2, 0.06, 0.06);
    problem.gap = std::vector<double>(6, 0.1);
    problem.approach = 0.2;
    problem.bodies.pair = ics;
    return problem;
}

json list_of(const GivenIcs& ics) {
    ArrayWriter arrays(ArrayEncoding::list);
    return encode_problem(problem(ics), arrays)["ics"]["table"];
}

json params_with(const json& ics) {
    json params = wire::solve_params();
    params.erase("bodies");
    params["ics"] = ics;
    return params;
}

json ics_params() {
    return {{"source", "table"}, {"table", list_of(given())}, {"dx", 0.06}, {"dy", 0.06}};
}

/// Returns field and problem of a refusal by the schema, the codec or the values.
std::string refusal_of(const json& params, const Frames& frames = {}) {
    try {
        check_params("contact.solve", params);
        validate(decode_problem(params, frames));
    } catch (const Error& error) {
        return error.what();
    }
    return "taken";
}

json export_params(const char* format) {
    json params = wire::ic_params();
    params["format"] = format;
    return params;
}

}  // namespace

TEST_CASE("Given coefficients arrive as they were sent", "[codec]") {
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    const ContactProblem original = problem(given(4, 5));
    ArrayWriter arrays(encoding);
    const json params = json::parse(dump(encode_problem(original, arrays)));
    const auto frames = arrays.take_frames();
    CHECK_FALSE(params.contains("bodies"));
    CHECK_NOTHROW(check_params("contact.solve", params));
    CHECK_NOTHROW(check_frames_used(params, frames));
    const ContactProblem read = decode_problem(params, frames);
    REQUIRE(read.bodies.pair);
    CHECK(read.bodies.pair->table.nx == 4);
    CHECK(read.bodies.pair->table.ny == 5);
    CHECK(read.bodies.pair->table.values == original.bodies.pair->table.values);
    CHECK(read.bodies.pair->dx == 0.06);
    CHECK_NOTHROW(validate(read));
}

TEST_CASE("With given coefficients bodies may be left out, or there for nothing", "[codec]") {
    json params = params_with(ics_params());
    CHECK(refusal_of(params) == "taken");
    params["bodies"] = {{"upper", {{"G", 1}, {"nu", 0.5}}}};
    CHECK(refusal_of(params) == "taken");
}

TEST_CASE("Without given coefficients bodies are required", "[codec]") {
    json params = wire::solve_params();
    params.erase("bodies");
    CHECK_THAT(refusal_of(params), ContainsSubstring("bodies is missing; it must be an object with upper and lower"));
}

TEST_CASE("A bad field beside the table is named", "[codec]") {
    struct Case {
        const char* pointer;
        const char* value;
        const char* says;
    };
    const auto c = GENERATE(
        Case{"/source", "\"tables\"", "ics.source is \"tables\"; it must be one of \"analytic\", \"fem\", \"table\""},
        Case{"/dx", "0", "ics.dx is 0; it must be positive"},
        Case{"/dx", "\"0.06\"", "ics.dx is \"0.06\"; it must be a number"},
        Case{"/dx", "0.0601", "ics.dx is 0.0601; the grid's elements are 0.06 along x"},
        Case{"/dy", "0.05", "ics.dy is 0.05; the grid's elements are 0.06 along y"},
        Case{"/table", "3", "ics.table is 3; it must be a list of numbers"},
        Case{"/table", "[]", "ics.table has shape [0]; it must be [3,3,ny,nx]"},
        Case{"/table", "[[[[[1, 2]]]]]", "ics.table has shape [1,1,1,1,2], that of a longitudinally uniform body"},
        Case{"/table", "[1, 2]", "ics.table has shape [2]"}, Case{"/order", "2", "ics.order is not a field of ics"},
        Case{"/table/1/2/0", "[1, 2]", "ics.table has 2 values at [1, 2, 0]"},
        Case{"/table/0/0/0/0", "\"1\"", "ics.table contains \"1\" at [0, 0, 0, 0]"},
        Case{"/table/2/2/0/0", "0", "ics.table contains 0 for zz at the offset (0, 0); it must be positive"},
        Case{"/table/0/0/0/0", "-1", "ics.table contains -1 for xx"},
        Case{"/table/1/1/1/2", "-1.5",
             "ics.table contains -1.5 for yy at the offset (2, 1); the value at (0, 0), the first in the table, must "
             "be the largest"});
    CAPTURE(c.pointer, c.value);
    json ics = ics_params();
    ics[json::json_pointer(c.pointer)] = json::parse(c.value);
    CHECK_THAT(refusal_of(params_with(ics)), ContainsSubstring(c.says));
}

TEST_CASE("Each part of given coefficients is required", "[codec]") {
    const std::string name = GENERATE("table", "dx", "dy", "source");
    json ics = ics_params();
    ics.erase(name);
    CHECK_THAT(refusal_of(params_with(ics)), ContainsSubstring("ics." + name + " is missing"));
}

TEST_CASE("A table that does not cover the grid is refused", "[codec]") {
    const auto [nx, ny] = GENERATE(std::pair{2, 2}, std::pair{3, 1});
    json ics = ics_params();
    ics["table"] = list_of(given(nx, ny));
    CHECK_THAT(refusal_of(params_with(ics)),
               ContainsSubstring("ics.table has shape [3,3," + std::to_string(ny) + "," + std::to_string(nx) + "]"));
}

TEST_CASE("A table in a frame is checked against its bytes", "[codec]") {
    json ics = ics_params();
    ics["table"] = json::parse(R"({"$array": {"frame": 1, "dtype": "<f8", "shape": [3, 3, 4000000, 4000000]}})");
    CHECK_THAT(refusal_of(params_with(ics), {"12345678"}), ContainsSubstring("has a frame of 8 bytes"));
    ics["table"]["$array"]["shape"] = {3, 3, 2, 3};
    CHECK_THAT(refusal_of(params_with(ics), {"12345678"}), ContainsSubstring("has a frame of 8 bytes"));
    ics["table"]["$array"]["shape"] = {54};
    CHECK_THAT(refusal_of(params_with(ics), {std::string(54 * 8, '\0')}),
               ContainsSubstring("ics.table has shape [54]"));
}

TEST_CASE("ic.get knows nothing of given coefficients", "[codec]") {
    json params = wire::ic_params();
    params["ics"] = ics_params();
    const auto status = wire::status_thrown_by([&] { check_params("ic.get", params); });
    REQUIRE(status);
    CHECK_THAT(status->message, ContainsSubstring("ics.source is \"table\"; it must be one of \"analytic\", \"fem\""));
}

TEST_CASE("The answer says that coefficients were given", "[codec]") {
    SolveReply reply;
    reply.solution.element_division.assign(6, ElementState::slip);
    reply.solution.pressure.assign(6, 1);
    reply.solution.traction_x = reply.solution.traction_y = reply.solution.pressure;
    reply.ics.pair = IcUse{"given", "abc", {}};
    reply.ics.pair->evidence.source = "table";
    ArrayWriter arrays(ArrayEncoding::frame);
    const json result = encode_solve_reply(reply, Grid::of_elements(3, 2, 1, 1), arrays);
    CHECK(violations_of("contact.solve.result", result).empty());
    const SolveReply read = decode_solve_reply(result, arrays.take_frames());
    REQUIRE(read.ics.pair);
    CHECK(read.ics.pair->origin == "given");
    CHECK(read.ics.pair->key == "abc");
    json both = result;
    both["evidence"]["ics"]["upper"] = both["evidence"]["ics"]["pair"];
    CHECK_FALSE(violations_of("contact.solve.result", both).empty());
}

TEST_CASE("An export is asked for like a table, with a format and perhaps a second body", "[codec]") {
    CHECK_NOTHROW(check_params("ic.export", export_params("hdf5")));
    const IcExport file = decode_ic_export(export_params("hdf5"));
    CHECK(file.format == FileFormat::hdf5);
    CHECK(file.spec == decode_ic_spec(wire::ic_params()));
    CHECK_FALSE(file.lower);
    json params = export_params("contact");
    params["lower"] = {{"G", 1}, {"nu", 0.1}};
    CHECK_NOTHROW(check_params("ic.export", params));
    const IcExport text = decode_ic_export(params);
    CHECK(text.format == FileFormat::contact);
    CHECK(text.lower == Material{1, 0.1});
}

TEST_CASE("What a client asks an export for arrives", "[codec]") {
    const IcSpec spec = decode_ic_spec(wire::ic_params());
    for (const IcExport& requested : {IcExport{spec, {}, FileFormat::hdf5}, IcExport{spec, {}, FileFormat::contents},
                                      IcExport{spec, Material{1, 0.1}, FileFormat::contact}}) {
        const json params = encode_ic_export(requested);
        CAPTURE(params.dump());
        CHECK_NOTHROW(check_params("ic.export", params));
        const IcExport read = decode_ic_export(params);
        CHECK(read.spec == requested.spec);
        CHECK(read.lower == requested.lower);
        CHECK(read.format == requested.format);
    }
}

TEST_CASE("A bad export is named with what would be right", "[codec]") {
    const auto refused = [](const json& params) {
        const auto status = wire::status_thrown_by([&] { check_params("ic.export", params); });
        return status ? status->message : "taken";
    };
    json params = export_params("contact");
    SECTION("no format") {
        params.erase("format");
        CHECK_THAT(refused(params),
                   ContainsSubstring("format is missing; it must be one of \"hdf5\", \"contents\", \"contact\""));
    }
    SECTION("another format") {
        params["format"] = "npz";
        CHECK_THAT(refused(params),
                   ContainsSubstring("format is \"npz\"; it must be one of \"hdf5\", \"contents\", \"contact\""));
    }
    SECTION("a path") {
        params["path"] = "table.txt";
        CHECK_THAT(refused(params), ContainsSubstring("path is not a field"));
    }
    SECTION("a second body in an IC file") {
        params["format"] = "hdf5";
        params["lower"] = {{"G", 1}, {"nu", 0.1}};
        CHECK_THAT(refused(params), ContainsSubstring("lower cannot be combined with format \"hdf5\""));
    }
    SECTION("a second body that is none") {
        params["lower"] = {{"G", -1}, {"nu", 0.1}};
        CHECK_THAT(refused(params), ContainsSubstring("lower.G is -1; it must be positive"));
    }
}

TEST_CASE("Exports are answered with bytes or text", "[codec]") {
    IcUse use{"built", "abc", {}};
    use.evidence.source = "fem";
    const std::vector<unsigned char> bytes{0, 255, 10, 7};
    ArrayWriter arrays(ArrayEncoding::frame);
    const json file = encode_hdf5_reply(bytes, use, arrays);
    CHECK(violations_of("ic.export.result", file).empty());
    CHECK(arrays.take_frames() == Frames{std::string("\0\xff\n\x07", 4)});
    const json text = encode_contact_text_reply("1 1\n", use, use);
    CHECK(violations_of("ic.export.result", text).empty());
    CHECK(text["text"] == "1 1\n");
    json neither = text;
    neither.erase("text");
    CHECK_FALSE(violations_of("ic.export.result", neither).empty());
}

TEST_CASE("What a file holds travels in both encodings of arrays", "[codec]") {
    FileContents contents;
    contents.attributes = {{"contactd_format", 2LL},
                           {"spec/nu", 0.25},
                           {"spec/body", std::string("longitudinally_uniform")},
                           {"evidence/family_nu", std::vector<double>{0, 0.5}},
                           {"evidence/warnings", std::vector<std::string>{"Mind the gap.", ""}}};
    contents.datasets["transform"] = {{2, 3}, UnsetArray{1, 2, 3, 4, 5, 6}};
    contents.datasets["spec/section"] = {{2}, UnsetArray{8, 0.5}};
    const ArrayEncoding encoding = GENERATE(ArrayEncoding::frame, ArrayEncoding::list);
    ArrayWriter arrays(encoding);
    const json params = json::parse(dump(encode_file_contents(contents, arrays)));
    CHECK_NOTHROW(check_params("ic.import", params));
    const FileContents read = decode_file_contents(params, arrays.take_frames());
    CHECK(read.attributes == contents.attributes);
    CHECK(read.datasets.at("transform").shape == contents.datasets["transform"].shape);
    CHECK(read.datasets.at("transform").values == contents.datasets["transform"].values);
    CHECK(read.datasets.at("spec/section").values == contents.datasets["spec/section"].values);
}

TEST_CASE("What no file holds is refused by its path", "[codec]") {
    const auto refused = [](const json& attributes, const json& datasets) {
        const json params{{"attributes", attributes}, {"datasets", datasets}};
        const auto status = wire::status_thrown_by([&] {
            check_params("ic.import", params);
            decode_file_contents(params, {});
        });
        return status ? status->message : "taken";
    };
    CHECK(refused(json::object(), json::object()) == "taken");
    CHECK_THAT(refused({{"../secret", 1}}, json::object()), ContainsSubstring("../secret"));
    CHECK_THAT(refused({{"a", {{"b", 1}}}}, json::object()), ContainsSubstring("attributes.a"));
    CHECK_THAT(refused({{"a", {1, "b"}}}, json::object()), ContainsSubstring("attributes.a mixes"));
    CHECK_THAT(refused({{"a", {"b", 1}}}, json::object()), ContainsSubstring("attributes.a mixes"));
    CHECK_THAT(refused({{"a", true}}, json::object()), ContainsSubstring("attributes.a"));
    CHECK_THAT(refused(json::object(), {{"frames", {{1, 2}, {3}}}}), ContainsSubstring("datasets.frames"));
    CHECK_THAT(refused(json::object(), {{"frames", 1}}), ContainsSubstring("datasets.frames"));
}
