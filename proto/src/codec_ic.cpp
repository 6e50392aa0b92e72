#include <cmath>

#include "codec_parts.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {

using nlohmann::json;

double finite(double value, const char* what) {
    if (!std::isfinite(value)) throw Error(std::string(what) + " is not finite and cannot be sent.");
    return value;
}

json encode_material(const Material& material) {
    return {{"G", finite(material.G, "G")}, {"nu", finite(material.nu, "nu")}};
}

Material decode_material(const json& source) {
    return {source["G"].get<double>(), source["nu"].get<double>()};
}

json encode_ics(const Ics& ics) {
    json result{{"source", name_of(ics.source)}, {"body", "half_space"}, {"load_shape", name_of(ics.load_shape)}};
    if (ics.source == IcSource::analytic) return result;
    const FemSpec& fem = ics.fem;
    result["mesh"] = name_of(fem.mesh);
    result["order"] = fem.order;
    result["l_over_h"] = finite(fem.l_over_h, "l_over_h");
    result["h_over_hs"] = finite(fem.h_over_hs, "h_over_hs");
    result["f"] = finite(fem.f, "f");
    result["L_over_h"] = finite(fem.L_over_h, "L_over_h");
    result["far_boundary"] = name_of(fem.far_boundary);
    result["sampling"] = name_of(fem.sampling);
    result["tolerance"] = finite(fem.tolerance, "tolerance");
    result["max_iterations"] = fem.max_iterations;
    result["strength_threshold"] = finite(fem.strength_threshold, "strength_threshold");
    return result;
}

Ics decode_ics(const json& source) {
    Ics ics;
    read_name(source["source"], ics.source);
    if (source.contains("load_shape")) read_name(source["load_shape"], ics.load_shape);
    if (ics.source == IcSource::analytic) return ics;
    FemSpec& fem = ics.fem;
    if (source.contains("preset")) {
        const auto preset = fem_preset(source["preset"].get<std::string>());
        if (!preset) throw invalid_field("ics.preset", "is " + source["preset"].dump() + "; there is no such preset");
        fem = *preset;
    }
    if (source.contains("mesh")) read_name(source["mesh"], fem.mesh);
    if (source.contains("far_boundary")) read_name(source["far_boundary"], fem.far_boundary);
    if (source.contains("sampling")) read_name(source["sampling"], fem.sampling);
    fem.order = source.value("order", fem.order);
    fem.l_over_h = source.value("l_over_h", fem.l_over_h);
    fem.h_over_hs = source.value("h_over_hs", fem.h_over_hs);
    fem.f = source.value("f", fem.f);
    fem.L_over_h = source.value("L_over_h", fem.L_over_h);
    fem.tolerance = source.value("tolerance", fem.tolerance);
    fem.max_iterations = source.value("max_iterations", fem.max_iterations);
    fem.strength_threshold = source.value("strength_threshold", fem.strength_threshold);
    return ics;
}

json encode_ic_spec(const IcSpec& spec) {
    return {{"material", encode_material(spec.material)},
            {"grid", {{"nx", spec.nx}, {"ny", spec.ny}, {"dx", finite(spec.dx, "dx")}, {"dy", finite(spec.dy, "dy")}}},
            {"ics", encode_ics({spec.source, spec.load_shape, spec.fem})}};
}

IcSpec decode_ic_spec(const json& params) {
    const json& grid = params["grid"];
    Ics ics = decode_ics(params["ics"]);
    IcSpec spec;
    spec.material = decode_material(params["material"]);
    spec.dx = grid["dx"].get<double>();
    spec.dy = grid["dy"].get<double>();
    spec.nx = grid["nx"].get<int>();
    spec.ny = grid["ny"].get<int>();
    spec.load_shape = ics.load_shape;
    spec.source = ics.source;
    spec.fem = ics.fem;
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
