// Results of wheelrail.*.
#include <span>
#include <utility>

#include "codec_parts.hpp"
#include "contactd/fields/wheel_rail_solution.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"
#include "contactd/proto/wheel_rail.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

json encode_patch(const WheelRailPatch& patch, const PatchFields& fields, ArrayWriter& arrays) {
    const Grid& grid = patch.place.grid;
    json solution = encode_summary(patch.solution, grid);
    encode_arrays(patch.solution, fields.solution, grid, arrays, solution);
    json result = object({{"place", write_answer(patch.place, MemberPath("place"))},
                          {"solution", std::move(solution)},
                          {"forces", write_answer(patch.forces, MemberPath("forces"))}});
    if (fields.gap && !patch.gap.empty())
        result["gap"] = arrays.write(std::span<const double>(patch.gap), shape_of(grid));
    return result;
}

WheelRailPatch decode_patch(const json& source, const Frames& frames) {
    WheelRailPatch patch;
    read_fields(source["place"], patch.place, MemberPath("place"));
    const std::vector<std::size_t> shape = shape_of(patch.place.grid);
    if (source.contains("gap")) patch.gap = read_array(source["gap"], frames, shape, "gap");
    decode_summary(source["solution"], patch.solution);
    decode_arrays(source["solution"], frames, shape, patch.solution);
    read_fields(source["forces"], patch.forces, MemberPath("forces"));
    return patch;
}

PatchesLeftOut decode_left_out(const json& result) {
    PatchesLeftOut left_out;
    if (!result.contains("contacts")) throw invalid_field("patches", "are missing, and so are contacts");
    left_out.count = result["contacts"].get<std::size_t>();
    left_out.converged = result["converged"].get<bool>();
    if (result.contains("frictional_power")) left_out.frictional_power = result["frictional_power"].get<double>();
    return left_out;
}

}  // namespace

json encode_wheel_rail_solution(const WheelRailSolution& solution, const PatchFields& fields, ArrayWriter& arrays) {
    json result = write_answer(solution, MemberPath("solution"));
    result["converged"] = solution.converged();
    if (fields.patches) {
        json& patches = result["patches"] = json::array();
        for (const WheelRailPatch& patch : solution.patches) patches.push_back(encode_patch(patch, fields, arrays));
    } else {
        result["contacts"] = solution.contacts();
    }
    if (const auto power = solution.frictional_power())
        result["frictional_power"] = finite(*power, "The frictional power");
    return result;
}

WheelRailSolution decode_wheel_rail_solution(const json& result, const Frames& frames) {
    WheelRailSolution solution;
    read_fields(result, solution, MemberPath("solution"));
    if (result.contains("patches"))
        for (const json& patch : result["patches"]) solution.patches.push_back(decode_patch(patch, frames));
    else
        solution.left_out = decode_left_out(result);
    return solution;
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
