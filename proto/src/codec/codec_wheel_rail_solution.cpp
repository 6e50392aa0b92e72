// Results of wheelrail.*.
#include <span>
#include <utility>

#include "codec_contact_place.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "named_numbers.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

// Each of something that may be const.
template <class Part>
auto numbers_of_wrench(Part& wrench) {
    return named(std::pair("Fx", &wrench.Fx), std::pair("Fy", &wrench.Fy), std::pair("Fz", &wrench.Fz),
                 std::pair("Mx", &wrench.Mx), std::pair("My", &wrench.My), std::pair("Mz", &wrench.Mz));
}

template <class Part>
auto wrenches_of(Part& forces) {
    return std::array{std::pair("track", &forces.track), std::pair("rail", &forces.rail),
                      std::pair("wheelset", &forces.wheelset)};
}

template <class Part>
auto searches_of(Part& solution) {
    return std::array{std::pair("force", &solution.force), std::pair("pitch_search", &solution.pitch_search),
                      std::pair("rail_search", &solution.rail_search)};
}

template <class Part>
auto wrenches_by_position(Part& by) {
    return std::array{std::pair("y", &by.y), std::pair("z", &by.z), std::pair("roll", &by.roll),
                      std::pair("yaw", &by.yaw)};
}

template <class Part>
auto wrenches_by_velocity(Part& by) {
    return std::array{std::pair("x", &by.x),       std::pair("y", &by.y),     std::pair("z", &by.z),
                      std::pair("roll", &by.roll), std::pair("yaw", &by.yaw), std::pair("pitch", &by.pitch)};
}

template <class Wrenches>
json encode_wrenches(const Wrenches& wrenches) {
    json result = json::object();
    for (const auto& [name, wrench] : wrenches) result[name] = encode_numbers(numbers_of_wrench(*wrench));
    return result;
}

template <class Wrenches>
void decode_wrenches(const json& source, const Wrenches& wrenches) {
    for (const auto& [name, wrench] : wrenches) decode_numbers(source[name], numbers_of_wrench(*wrench));
}

json encode_forces(const WheelRailForces& forces) {
    return encode_wrenches(wrenches_of(forces));
}

WheelRailForces decode_forces(const json& source) {
    WheelRailForces forces;
    decode_wrenches(source, wrenches_of(forces));
    return forces;
}

json encode_derivatives(const WheelRailDerivatives& derivatives) {
    return object({{"position", encode_wrenches(wrenches_by_position(derivatives.position))},
                   {"velocity", encode_wrenches(wrenches_by_velocity(derivatives.velocity))}});
}

WheelRailDerivatives decode_wheel_rail_derivatives(const json& source) {
    WheelRailDerivatives derivatives;
    decode_wrenches(source["position"], wrenches_by_position(derivatives.position));
    decode_wrenches(source["velocity"], wrenches_by_velocity(derivatives.velocity));
    return derivatives;
}

json encode_patch(const WheelRailPatch& patch, const PatchFields& fields, ArrayWriter& arrays) {
    const Grid& grid = patch.place.grid;
    json solution = encode_summary(patch.solution, grid);
    solution["evidence"] = encode_evidence(patch.solution.evidence);
    encode_arrays(patch.solution, fields.solution, grid, arrays, solution);
    json result = object({{"place", encode_place(patch.place)},
                          {"solution", std::move(solution)},
                          {"forces", encode_forces(patch.forces)}});
    if (fields.gap && !patch.gap.empty())
        result["gap"] = arrays.write(std::span<const double>(patch.gap), shape_of(grid));
    return result;
}

WheelRailPatch decode_patch(const json& source, const Frames& frames) {
    WheelRailPatch patch;
    patch.place = decode_place(source["place"]);
    const std::vector<std::size_t> shape = shape_of(patch.place.grid);
    if (source.contains("gap")) patch.gap = read_array(source["gap"], frames, shape, "gap");
    decode_summary(source["solution"], patch.solution);
    patch.solution.evidence = decode_contact_evidence(source["solution"]["evidence"]);
    decode_arrays(source["solution"], frames, shape, patch.solution);
    patch.forces = decode_forces(source["forces"]);
    return patch;
}

json encode_geometry(const WheelRailGeometry& geometry) {
    json places = json::array();
    for (const ContactPlace& place : geometry.places) places.push_back(encode_place(place));
    json result = object({{"z", finite(geometry.z, "z of the wheelset")},
                          {"places", std::move(places)},
                          {"warnings", geometry.warnings}});
    if (geometry.clearance) result["clearance"] = finite(*geometry.clearance, "The clearance");
    return result;
}

WheelRailGeometry decode_geometry(const json& source) {
    WheelRailGeometry geometry;
    geometry.z = source["z"].get<double>();
    for (const json& place : source["places"]) geometry.places.push_back(decode_place(place));
    if (source.contains("clearance")) geometry.clearance = source["clearance"].get<double>();
    geometry.warnings = source["warnings"].get<std::vector<std::string>>();
    return geometry;
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
    json result = object({{"z", finite(solution.z, "z of the wheelset")},
                          {"pitch", finite(solution.pitch, "The pitch rate")},
                          {"forces", encode_forces(solution.forces)},
                          {"warnings", solution.warnings},
                          {"converged", solution.converged()}});
    if (fields.patches) {
        json& patches = result["patches"] = json::array();
        for (const WheelRailPatch& patch : solution.patches) patches.push_back(encode_patch(patch, fields, arrays));
    } else {
        result["contacts"] = solution.contacts();
    }
    if (const auto power = solution.frictional_power())
        result["frictional_power"] = finite(*power, "The frictional power");
    if (solution.clearance) result["clearance"] = finite(*solution.clearance, "The clearance");
    for (const auto& [name, search] : searches_of(solution))
        if (*search) result[name] = encode_solver_evidence(**search);
    if (solution.rail_shift)
        result["rail_shift"] = object({{"y", finite(solution.rail_shift->y, "The shift of the rail")},
                                       {"z", finite(solution.rail_shift->z, "The shift of the rail")}});
    if (solution.derivatives) result["derivatives"] = encode_derivatives(*solution.derivatives);
    return result;
}

WheelRailSolution decode_wheel_rail_solution(const json& result, const Frames& frames) {
    WheelRailSolution solution;
    solution.z = result["z"].get<double>();
    solution.pitch = result["pitch"].get<double>();
    if (result.contains("clearance")) solution.clearance = result["clearance"].get<double>();
    if (result.contains("patches"))
        for (const json& patch : result["patches"]) solution.patches.push_back(decode_patch(patch, frames));
    else
        solution.left_out = decode_left_out(result);
    solution.forces = decode_forces(result["forces"]);
    for (const auto& [name, search] : searches_of(solution))
        if (result.contains(name)) *search = decode_solver_evidence(result[name]);
    if (result.contains("rail_shift"))
        solution.rail_shift = {result["rail_shift"]["y"].get<double>(), result["rail_shift"]["z"].get<double>()};
    if (result.contains("derivatives")) solution.derivatives = decode_wheel_rail_derivatives(result["derivatives"]);
    solution.warnings = result["warnings"].get<std::vector<std::string>>();
    return solution;
}

json encode_wheelset_solution(const WheelsetSolution& solution, const PatchFields& fields, ArrayWriter& arrays) {
    return object({{"z", finite(solution.z, "z of the wheelset")},
                   {"roll", finite(solution.roll, "The roll")},
                   {"left", encode_wheel_rail_solution(solution.left, fields, arrays)},
                   {"right", encode_wheel_rail_solution(solution.right, fields, arrays)},
                   {"roll_search", encode_solver_evidence(solution.roll_search)},
                   {"warnings", solution.warnings},
                   {"converged", solution.converged()}});
}

WheelsetSolution decode_wheelset_solution(const json& result, const Frames& frames) {
    WheelsetSolution solution;
    solution.z = result["z"].get<double>();
    solution.roll = result["roll"].get<double>();
    solution.left = decode_wheel_rail_solution(result["left"], frames);
    solution.right = decode_wheel_rail_solution(result["right"], frames);
    solution.roll_search = decode_solver_evidence(result["roll_search"]);
    solution.warnings = result["warnings"].get<std::vector<std::string>>();
    return solution;
}

json encode_wheel_rail_geometries(std::span<const WheelRailGeometry> geometries) {
    json result = object({{"geometries", json::array()}});
    for (const WheelRailGeometry& geometry : geometries) result["geometries"].push_back(encode_geometry(geometry));
    return result;
}

std::vector<WheelRailGeometry> decode_wheel_rail_geometries(const json& result) {
    std::vector<WheelRailGeometry> geometries;
    for (const json& geometry : result["geometries"]) geometries.push_back(decode_geometry(geometry));
    return geometries;
}

}  // namespace contactd::proto
