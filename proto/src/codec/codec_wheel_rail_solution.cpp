// Encodes and decodes results of wheelrail.*.
#include <span>
#include <utility>

#include "codec_parts.hpp"
#include "contactd/fields/wheel_rail_solution.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "field_text.hpp"
#include "wire/json_access.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

void append_patch(std::string& text, const WheelRailPatch& patch, const PatchFields& fields, ArrayWriter& arrays) {
    const Grid& grid = patch.place.grid;
    text += '{';
    append_name(text, "place");
    append_answer(text, patch.place, MemberPath("place"));
    append_name(text, "solution");
    text += '{';
    append_summary(text, patch.solution, grid);
    append_arrays(text, patch.solution, fields.solution, grid, arrays);
    text += '}';
    append_name(text, "forces");
    append_answer(text, patch.forces, MemberPath("forces"));
    if (fields.gap && !patch.gap.empty()) {
        append_name(text, "gap");
        text += dump(arrays.write(std::span<const double>(patch.gap), shape_of(grid)));
    }
    text += '}';
}

template <class Source>
WheelRailPatch read_patch(const Source& source, const Frames& frames) {
    WheelRailPatch patch;
    read_fields(source["place"], patch.place, MemberPath("place"));
    const std::vector<std::size_t> shape = shape_of(patch.place.grid);
    if (const auto gap = member_of(source, "gap")) patch.gap = read_array(as_json(*gap), frames, shape, "gap");
    const Source& solution = source["solution"];
    decode_summary(solution, patch.solution);
    decode_arrays(solution, frames, shape, patch.solution);
    read_fields(source["forces"], patch.forces, MemberPath("forces"));
    return patch;
}

template <class Source>
PatchesLeftOut read_left_out(const Source& result) {
    PatchesLeftOut left_out;
    const auto contacts = member_of(result, "contacts");
    if (!contacts) throw invalid_field("patches", "are missing, and so are contacts; give one of them");
    left_out.count = static_cast<std::size_t>(integer_of(*contacts));
    left_out.converged = flag_of(result["converged"]);
    if (const auto power = member_of(result, "frictional_power")) left_out.frictional_power = number_of(*power);
    return left_out;
}

template <class Source>
WheelRailSolution read_solution(const Source& result, const Frames& frames) {
    WheelRailSolution solution;
    read_fields(result, solution, MemberPath("solution"));
    if (const auto patches = member_of(result, "patches"))
        for (const auto& patch : *patches) solution.patches.push_back(read_patch(patch, frames));
    else
        solution.left_out = read_left_out(result);
    return solution;
}

}  // namespace

std::string write_wheel_rail_solution(const WheelRailSolution& solution, const PatchFields& fields,
                                      ArrayWriter& arrays) {
    std::string text = "{";
    append_members(text, solution, MemberPath("solution"));
    append_name(text, "converged");
    text += solution.converged() ? "true" : "false";
    if (fields.patches) {
        append_name(text, "patches");
        text += '[';
        for (const WheelRailPatch& patch : solution.patches) {
            if (text.back() != '[') text += ',';
            append_patch(text, patch, fields, arrays);
        }
        text += ']';
    } else {
        append_name(text, "contacts");
        text += std::to_string(solution.contacts());
    }
    if (const auto power = solution.frictional_power()) {
        append_name(text, "frictional_power");
        append_number(text, finite(*power, "The frictional power"));
    }
    return text + "}";
}

json encode_wheel_rail_solution(const WheelRailSolution& solution, const PatchFields& fields, ArrayWriter& arrays) {
    return json::parse(write_wheel_rail_solution(solution, fields, arrays));
}

WheelRailSolution decode_wheel_rail_solution(const json& result, const Frames& frames) {
    return read_solution(result, frames);
}

WheelRailSolution decode_wheel_rail_solution(const AnswerValue& result, const Frames& frames) {
    return read_solution(result, frames);
}

json encode_wheelset_solution(const WheelsetSolution& solution, const PatchFields& fields, ArrayWriter& arrays) {
    json result = write_answer(solution, MemberPath("solution"));
    result["left"] = encode_wheel_rail_solution(solution.left, fields, arrays);
    result["right"] = encode_wheel_rail_solution(solution.right, fields, arrays);
    result["converged"] = solution.converged();
    return result;
}

WheelsetSolution decode_wheelset_solution(const json& result, const Frames& frames) {
    WheelsetSolution solution;
    read_fields(result, solution, MemberPath("solution"));
    solution.left = decode_wheel_rail_solution(result["left"], frames);
    solution.right = decode_wheel_rail_solution(result["right"], frames);
    return solution;
}

json encode_wheel_rail_geometries(std::span<const WheelRailGeometry> geometries) {
    json result = object({{"geometries", json::array()}});
    for (const WheelRailGeometry& geometry : geometries)
        result["geometries"].push_back(write_answer(geometry, MemberPath("geometry")));
    return result;
}

std::vector<WheelRailGeometry> decode_wheel_rail_geometries(const json& result) {
    std::vector<WheelRailGeometry> geometries;
    for (const json& geometry : result["geometries"])
        read_fields(geometry, geometries.emplace_back(), MemberPath("geometry"));
    return geometries;
}

}  // namespace contactd::proto
