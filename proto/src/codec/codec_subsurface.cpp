// Encodes and decodes contact.subsurface.
#include <algorithm>
#include <cmath>

#include "codec_parts.hpp"
#include "codec_section.hpp"
#include "contactd/fields/subsurface_stress.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/field_codec.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;
using Shape = std::vector<std::size_t>;
using Values = std::vector<double>;

constexpr std::size_t arrays_of_result = 7, arrays_of_invariants = 5, arrays_of_displacement = 3;
constexpr std::size_t longest_axis = 4'000'000;  // values of an array on the wire
/// The squares of larger tractions exceed the range of a double.
constexpr double largest_traction = 1e100;

/// Returns pointers to the tractions of a request, which may be const, with their names.
template <class Request>
auto tractions_of(Request& request) {
    return std::array{std::pair("pressure", &request.pressure), std::pair("traction_x", &request.traction_x),
                      std::pair("traction_y", &request.traction_y)};
}

template <class Block>
auto axes_of(Block& block) {
    return std::array{std::pair("x", &block.x), std::pair("y", &block.y), std::pair("z", &block.z)};
}

template <class Stress>
auto components_of(Stress& stress) {
    return std::array{std::pair("xx", &stress.xx), std::pair("yy", &stress.yy), std::pair("zz", &stress.zz),
                      std::pair("xy", &stress.xy), std::pair("xz", &stress.xz), std::pair("yz", &stress.yz)};
}

template <class Stress>
auto invariants_of(Stress& stress) {
    return std::array{std::pair("hydrostatic", &stress.hydrostatic), std::pair("principal_1", &stress.principal_1),
                      std::pair("principal_2", &stress.principal_2), std::pair("principal_3", &stress.principal_3),
                      std::pair("tresca", &stress.tresca)};
}

json write(const Values& values, const Shape& shape, ArrayWriter& arrays) {
    return arrays.write(std::span<const double>(values), shape);
}

/// Limits the size of results before any of that size is allocated. `points` may exceed the range of an integer.
void check_number(double points, std::size_t arrays, const char* field, const MessageLimits& limits) {
    const std::size_t most = std::min(limits.max_array_elements / arrays, longest_axis);
    if (points > static_cast<double>(most))
        throw invalid_field(field,
                            "has " + (points < 1e15 ? dump(static_cast<long long>(points)) : dump(points)) +
                                " points; at most " + std::to_string(most) +
                                " are allowed (limits.max_array_elements, for the " + std::to_string(arrays) +
                                " arrays of the result together)",
                            reason::limit_exceeded);
}

StressPoints decode_points(const json& source, const Frames& frames, std::size_t arrays, const MessageLimits& limits) {
    const Shape shape = claimed_shape(source, 2);
    if (shape.size() != 2 || shape[1] != 3)
        throw invalid_field("points", "has shape " + json(shape).dump() + "; it must be [n,3]", reason::array_invalid);
    check_number(static_cast<double>(shape[0]), arrays, "points", limits);
    const Values values = read_array(source, frames, shape, "points");
    StressPoints points(shape[0]);
    for (std::size_t i = 0; i < points.size(); ++i) std::copy_n(&values[3 * i], 3, points[i].begin());
    return points;
}

StressBlock decode_block(const json& source, const Frames& frames, std::size_t arrays, const MessageLimits& limits) {
    StressBlock block;
    double points = 1;
    for (const auto& [name, values] : axes_of(block)) {
        const Shape shape = claimed_shape(source[name], 1);
        const std::string field = std::string("block.") + name;
        if (shape.size() != 1)
            throw invalid_field(field, "has shape " + json(shape).dump() + "; it must be a list of numbers",
                                reason::array_invalid);
        points *= static_cast<double>(shape[0]);
        check_number(std::max(points, static_cast<double>(shape[0])), arrays, "block", limits);
    }
    for (const auto& [name, values] : axes_of(block))
        *values = read_array(source[name], frames, claimed_shape(source[name], 1), std::string("block.") + name);
    return block;
}

void check_has_stresses(const Ics& ics, bool is_curved) {
    if (is_curved && (ics.layered || ics.line_contact))
        throw invalid_field("angles", "are given, but ics has layers or a line contact, whose rows lie in a plane");
    if (is_curved && ics.body == BodyShape::longitudinally_uniform) return;
    if (ics.line_contact && (ics.body != BodyShape::half_space || ics.source != IcSource::analytic))
        throw invalid_field("ics.line_contact",
                            "requires half-spaces in closed form for stresses below a line contact");
    if (ics.body == BodyShape::layered) return;
    if (ics.body == BodyShape::longitudinally_uniform)
        throw invalid_field("ics.body",
                            "is longitudinally_uniform, whose stresses are those of a half-space for each row: give "
                            "the angles of the rows");
    if (ics.body != BodyShape::half_space)
        throw invalid_field("ics.body",
                            "is block, but the stresses are those of a half-space, which are accurate for a block only "
                            "at depths well below its size and far from its faces. Remove ics to use them anyway");
}

}  // namespace

json encode_subsurface_request(const SubsurfaceRequest& request, ArrayWriter& arrays) {
    json params{{"grid", encode_grid(request.grid)}, {"nu", finite(request.nu, "nu")}, {"body", name_of(request.body)}};
    if (request.invariants) params["invariants"] = true;
    if (!request.angles.empty()) params["angles"] = request.angles;
    if (request.G) params["G"] = finite(*request.G, "G");
    if (request.ics != Ics{}) params["ics"] = encode_ics(request.ics);
    for (const auto& [name, values] : tractions_of(request))
        if (!values->empty()) params[name] = write(*values, shape_of(request.grid), arrays);
    if (const auto* block = std::get_if<StressBlock>(&request.points)) {
        for (const auto& [name, values] : axes_of(*block))
            params["block"][name] = write(*values, {values->size()}, arrays);
        return params;
    }
    Values flat;
    for (const auto& point : std::get<StressPoints>(request.points))
        flat.insert(flat.end(), point.begin(), point.end());
    params["points"] = write(flat, {flat.size() / 3, 3}, arrays);
    return params;
}

SubsurfaceRequest decode_subsurface_request(const json& params, const Frames& frames, const MessageLimits& limits) {
    SubsurfaceRequest request;
    request.grid = decode_grid(params["grid"]);
    request.nu = params["nu"].get<double>();
    if (params.contains("body")) read_name(params["body"], request.body);
    if (params.contains("ics")) request.ics = decode_ics(params["ics"], frames);
    if (params.contains("angles")) request.angles = params["angles"].get<std::vector<double>>();
    check_has_stresses(request.ics, !request.angles.empty());
    request.invariants = params.value("invariants", false);
    if (params.contains("G")) request.G = params["G"].get<double>();
    if (request.G && !request.angles.empty())
        throw invalid_field(
            "G", "cannot be combined with angles; displacements are those of half-spaces under a plane contact");
    if (request.G && request.ics.line_contact)
        throw invalid_field(
            "G",
            "cannot be combined with ics.line_contact, because displacements below an infinite line are unbounded");
    if (request.G && request.ics.layered)
        throw invalid_field("G", "is given, but displacements are those of half-spaces, and ics has layers");
    const std::size_t arrays =
        arrays_of_result + (request.invariants ? arrays_of_invariants : 0) + (request.G ? arrays_of_displacement : 0);
    if (params.contains("block"))
        request.points = decode_block(params["block"], frames, arrays, limits);
    else
        request.points = decode_points(params["points"], frames, arrays, limits);
    for (const auto& [name, values] : tractions_of(request)) {
        if (!params.contains(name)) continue;
        *values = read_array(params[name], frames, shape_of(request.grid), name);
        for (const double value : *values)
            if (std::abs(value) > largest_traction)
                throw invalid_field(name, "contains " + dump(value) + "; its values must lie in [-1e100, 1e100]",
                                    reason::array_invalid);
    }
    return request;
}

json encode_subsurface_reply(const SubsurfaceReply& reply, ArrayWriter& arrays) {
    json result{{"shape", reply.shape}, {"largest", write_answer(reply.largest, MemberPath("largest"))}};
    result["largest"]["depth"] = reply.largest.depth();
    for (const auto& [name, values] : components_of(reply.stress))
        result["stress"][name] = write(*values, reply.shape, arrays);
    result["von_mises"] = write(reply.stress.von_mises, reply.shape, arrays);
    if (reply.displacement)
        for (const auto& [name, values] : axes_of(*reply.displacement))
            result[std::string("displacement_") + name] = write(*values, reply.shape, arrays);
    for (const auto& [name, values] : invariants_of(reply.stress))
        if (!values->empty()) result[name] = write(*values, reply.shape, arrays);
    return result;
}

SubsurfaceReply decode_subsurface_reply(const json& result, const Frames& frames) {
    SubsurfaceReply reply;
    reply.shape = result["shape"].get<Shape>();
    read_fields(result["largest"], reply.largest, MemberPath("largest"));
    for (const auto& [name, values] : components_of(reply.stress))
        *values = read_array(result["stress"][name], frames, reply.shape, std::string("stress.") + name);
    if (result.contains("displacement_x"))
        for (const auto& [name, values] : axes_of(reply.displacement.emplace())) {
            const std::string path = std::string("displacement_") + name;
            *values = read_array(result[path], frames, reply.shape, path);
        }
    for (const auto& [name, values] : invariants_of(reply.stress))
        if (result.contains(name)) *values = read_array(result[name], frames, reply.shape, name);
    Values& von_mises = reply.stress.von_mises;
    von_mises = read_array(result["von_mises"], frames, reply.shape, "von_mises");
    reply.stress.largest =
        static_cast<std::size_t>(std::max_element(von_mises.begin(), von_mises.end()) - von_mises.begin());
    return reply;
}

}  // namespace contactd::proto
