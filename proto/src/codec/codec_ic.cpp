#include <cmath>

#include "codec_parts.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/object.hpp"

namespace contactd::proto {

using nlohmann::json;

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
    if (!spec.layered) result["material"] = encode_material(spec.material);
    return result;
}

IcSpec decode_ic_spec(const json& params) {
    const json& grid = params["grid"];
    IcSpec spec{decode_ics(params["ics"]), {}, 0, 0, 0, 0};
    spec.material = spec.layered ? spec.layered->surface() : decode_material(params["material"]);
    spec.dx = grid["dx"].get<double>();
    spec.dy = grid["dy"].get<double>();
    spec.nx = decode_count(grid, "nx");
    spec.ny = decode_count(grid, "ny");
    return spec;
}

json encode_ic_reply(const IcReply& reply, ArrayWriter& arrays) {
    const auto nx = static_cast<std::size_t>(reply.table.nx), ny = static_cast<std::size_t>(reply.table.ny);
    return {{"key", reply.key},
            {"origin", reply.origin},
            {"spec", encode_ic_spec(reply.spec)},
            {"table", arrays.write(std::span<const double>(reply.table.values), {3, 3, ny, nx})},
            {"evidence", encode_evidence(reply.evidence)}};
}

IcReply decode_ic_reply(const json& result, const std::vector<std::string>& frames) {
    IcReply reply;
    reply.key = result["key"].get<std::string>();
    reply.origin = result["origin"].get<std::string>();
    reply.spec = decode_ic_spec(result["spec"]);
    reply.table.nx = reply.spec.nx;
    reply.table.ny = reply.spec.ny;
    const auto nx = static_cast<std::size_t>(reply.spec.nx), ny = static_cast<std::size_t>(reply.spec.ny);
    reply.table.values = read_array(result["table"], frames, {3, 3, ny, nx}, "table");
    reply.evidence = decode_evidence(result["evidence"]);
    return reply;
}

}  // namespace contactd::proto
