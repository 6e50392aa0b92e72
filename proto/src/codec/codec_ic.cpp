#include <cmath>

#include "codec_parts.hpp"
#include "codec_section.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/import_codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {

using nlohmann::json;

constexpr const char* material_field = "material";

double finite(double value, const char* what) {
    if (!std::isfinite(value)) throw Error(std::string(what) + " is not finite and cannot be sent.");
    return value;
}

double finite_field(double value, const char* field) {
    if (!std::isfinite(value)) throw InvalidArgument(field, "is not finite and cannot be sent; it must be a number");
    return value;
}

json encode_material(const Material& material) {
    return object({{"G", finite(material.G, "G")}, {"nu", finite(material.nu, "nu")}});
}

Material decode_material(const json& source) {
    return {source["G"].get<double>(), source["nu"].get<double>()};
}

json encode_ic_spec(const IcSpec& spec) {
    json result{
        {"grid", {{"nx", spec.nx}, {"ny", spec.ny}, {"dx", finite(spec.dx, "dx")}, {"dy", finite(spec.dy, "dy")}}},
        {"ics", encode_ics(spec)}};
    if (!spec.layered) result[material_field] = encode_material(spec.material);
    return result;
}

IcSpec decode_ic_spec(const json& params) {
    return decode_ic_spec(params, {});
}

IcSpec decode_ic_spec(const json& params, const Frames& frames) {
    const json& grid = params["grid"];
    IcSpec spec{decode_ics(params["ics"], frames), {}, 0, 0, 0, 0};
    // The schema of an answer does not require the material, because layers have their own.
    if (!spec.layered && !params.contains(material_field))
        throw invalid_field(material_field, "is missing; a body without layers requires it");
    spec.material = spec.layered ? spec.layered->surface() : decode_material(params[material_field]);
    spec.dx = grid["dx"].get<double>();
    spec.dy = grid["dy"].get<double>();
    spec.nx = decode_count(grid, "nx");
    spec.ny = decode_count(grid, "ny");
    return spec;
}

namespace {

/// Returns the shape of a table. Rows of a longitudinally uniform body's table are pairs of columns.
std::vector<std::size_t> table_shape(const IcSpec& spec) {
    const auto nx = static_cast<std::size_t>(spec.nx), ny = static_cast<std::size_t>(spec.ny);
    if (spec.section) return {3, 3, ny, ny, nx};
    return {3, 3, ny, nx};
}

}  // namespace

json encode_frames(const std::vector<StripFrame>& columns, ArrayWriter& arrays) {
    std::vector<double> values;
    for (const StripFrame& frame : columns) values.insert(values.end(), {frame.y, frame.z, frame.angle});
    return arrays.write(std::span<const double>(values), {columns.size(), 3});
}

std::vector<StripFrame> decode_frames(const json& source, const Frames& frames, int strips, const std::string& field) {
    const std::vector<double> values = read_array(source, frames, {static_cast<std::size_t>(strips), 3}, field);
    std::vector<StripFrame> result;
    for (std::size_t at = 0; at + 2 < values.size(); at += 3)
        result.push_back({values[at], values[at + 1], values[at + 2]});
    return result;
}

json encode_ic_reply(IcReply reply, ArrayWriter& arrays) {
    json result{{"key", reply.key},
                {"origin", reply.origin},
                {"spec", encode_ic_spec(reply.spec)},
                {"table", arrays.write_finite(std::move(reply.table.values), table_shape(reply.spec))},
                {"evidence", encode_evidence(reply.evidence)}};
    if (!reply.frames.empty()) result["frames"] = encode_frames(reply.frames, arrays);
    return result;
}

IcReply decode_ic_reply(const json& result, const Frames& frames) {
    IcReply reply;
    reply.key = result["key"].get<std::string>();
    reply.origin = result["origin"].get<std::string>();
    reply.spec = decode_ic_spec(result["spec"]);
    reply.table.nx = reply.spec.nx;
    reply.table.ny = table_rows(reply.spec);
    reply.table.values = read_unset_array(result["table"], frames, table_shape(reply.spec), "table");
    reply.evidence = decode_evidence(result["evidence"]);
    if (result.contains("frames")) reply.frames = decode_frames(result["frames"], frames, reply.spec.ny, "frames");
    return reply;
}

}  // namespace contactd::proto
