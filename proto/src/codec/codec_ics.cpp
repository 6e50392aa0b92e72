// `ics` of a request, and the mesh that evidence speaks of.
#include <optional>
#include <string_view>
#include <type_traits>

#include "codec_parts.hpp"
#include "codec_section.hpp"
#include "contactd/fem_fields.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr double default_accuracy = 1e-3;

/// Whether the request names a mesh or a solver. The size of a block belongs to the body.
bool names_a_mesh(const json& ics, BodyShape body) {
    bool found = ics.contains("preset");
    for_each_fem_field([&](const auto& field) {
        const bool of_body = body == BodyShape::block && field.name == std::string_view("L_over_h");
        found = found || (ics.contains(field.name) && !of_body);
    });
    return found;
}

FemSpec named_mesh(const json& ics, BodyShape body) {
    FemSpec fem;
    if (body == BodyShape::block) fem.far_boundary = FarBoundary::clamped;
    if (ics.contains("preset")) {
        const auto preset = fem_preset(ics["preset"].get<std::string>());
        if (!preset) throw invalid_field("ics.preset", "is " + ics["preset"].dump() + "; there is no such preset");
        fem = *preset;
    }
    decode_fem(ics, fem);
    return fem;
}

template <class Value>
void write_field(json& at, const char* name, const Value& value) {
    if constexpr (HasWords<Value>)
        at[name] = name_of(value);
    else if constexpr (std::is_integral_v<Value>)
        at[name] = value;
    else
        at[name] = finite(value, name);
}
void write_field(json& at, const char* name, const std::optional<double>& value) {
    if (value) write_field(at, name, *value);
}

template <class Value>
void read_field(const json& source, Value& value) {
    if constexpr (HasWords<Value>)
        read_name(source, value);
    else
        value = source.get<Value>();
}
void read_field(const json& source, std::optional<double>& value) {
    value = source.get<double>();
}

template <class Part>
json encode_part(const Part& part) {
    json result;
    for_each_part_field<Part>(
        [&](const PartField<Part>& field) { write_field(result, field.name, part.*field.member); });
    return result;
}

template <class Part>
Part decode_part(const json& source) {
    Part part;
    for_each_part_field<Part>(
        [&](const PartField<Part>& field) { read_field(source[field.name], part.*field.member); });
    return part;
}

json encode_layer(const Layer& layer) {
    return object({{"thickness", finite(layer.thickness, "thickness")},
                   {"G", finite(layer.G, "G")},
                   {"nu", finite(layer.nu, "nu")}});
}

Layers decode_layers(const json& source) {
    Layers body;
    for (const json& layer : source["layers"])
        body.layers.push_back({layer["thickness"].get<double>(), layer["G"].get<double>(), layer["nu"].get<double>()});
    const json& base = source["base"];
    body.base = base.contains("rigid") ? Material::rigid() : decode_material(base);
    return body;
}

}  // namespace

json encode_fem(const FemSpec& fem) {
    json result;
    for_each_fem_field([&](const auto& field) { write_field(result, field.name, fem.*field.member); });
    return result;
}

void decode_fem(const json& source, FemSpec& fem) {
    for_each_fem_field([&](const auto& field) {
        if (source.contains(field.name)) read_field(source[field.name], fem.*field.member);
    });
}

json encode_ics(const Ics& ics) {
    json result{{"source", name_of(ics.source)}, {"body", name_of(ics.body)}, {"load_shape", name_of(ics.load_shape)}};
    for_each_ics_part([&](const auto& part) {
        if (const auto& value = ics.*part.member) result[part.name] = encode_part(*value);
    });
    if (ics.layered) {
        for (const Layer& layer : ics.layered->layers) result["layers"].push_back(encode_layer(layer));
        const Material& base = ics.layered->base;
        result["base"] = base.is_rigid() ? json{{"rigid", true}} : encode_material(base);
    }
    if (ics.section) result["section"] = encode_section(*ics.section);
    if (ics.source == IcSource::analytic) return result;
    if (ics.accuracy != 0) {
        result["accuracy"] = finite(ics.accuracy, "accuracy");
        if (ics.body == BodyShape::block) result["L_over_h"] = finite(ics.fem.L_over_h, "L_over_h");
    } else {
        result.update(encode_fem(ics.fem));
    }
    if (!ics.section) result["any_nu"] = ics.any_nu;
    return result;
}

Ics decode_ics(const json& source) {
    return decode_ics(source, {});
}

Ics decode_ics(const json& source, const Frames& frames) {
    Ics ics;
    read_name(source["source"], ics.source);
    if (source.contains("body")) read_name(source["body"], ics.body);
    if (source.contains("load_shape")) read_name(source["load_shape"], ics.load_shape);
    if (ics.body == BodyShape::layered) ics.layered = decode_layers(source);
    if (source.contains("section")) ics.section = decode_section(source["section"], frames, "ics.section");
    for_each_ics_part([&]<class Part>(const IcsPart<Part>& part) {
        if (source.contains(part.name)) ics.*part.member = decode_part<Part>(source[part.name]);
    });
    if (ics.source == IcSource::analytic) return ics;
    ics.any_nu = source.value("any_nu", false);
    if (!source.contains("accuracy") && names_a_mesh(source, ics.body)) {
        ics.fem = named_mesh(source, ics.body);
        return ics;
    }
    ics.accuracy = source.value("accuracy", default_accuracy);
    ics.fem.L_over_h = source.value("L_over_h", ics.fem.L_over_h);
    return ics;
}

}  // namespace contactd::proto
