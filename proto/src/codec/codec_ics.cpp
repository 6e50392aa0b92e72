// Encodes and decodes `ics` of a request, and the mesh in evidence.
#include <algorithm>
#include <utility>

#include "codec_parts.hpp"
#include "codec_section.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr double default_accuracy = 1e-3;

/// Returns whether the request specifies a mesh or a solver. The size of a block belongs to the body.
bool names_a_mesh(const json& ics, BodyShape body) {
    return ics.contains("preset") || std::ranges::any_of(type_of<FemSpec>().fields, [&](const Field& field) {
               return ics.contains(field.name) && !(body == BodyShape::block && field.name == "L_over_h");
           });
}

/// Returns the mesh that fields of the request modify: the preset, or the default.
FemSpec base_mesh(const json& ics, BodyShape body) {
    FemSpec fem;
    if (body == BodyShape::block) fem.far_boundary = FarBoundary::clamped;
    if (!ics.contains("preset")) return fem;
    const auto preset = fem_preset(ics["preset"].get<std::string>());
    if (!preset) throw invalid_field("ics.preset", "is " + ics["preset"].dump() + ", which is not a preset");
    return *preset;
}

}  // namespace

json encode_fem(const FemSpec& fem) {
    return write_fields(fem, MemberPath("ics"));
}

void decode_fem(const json& source, FemSpec& fem) {
    read_fields(source, fem, MemberPath("ics"));
}

// Omits fields that do not apply to the source.
json encode_ics(const Ics& ics) {
    json result = write_fields(ics, MemberPath("ics"));
    const bool is_built = ics.source == IcSource::fem;
    if (!is_built || ics.accuracy != 0)
        for (const Field& field : type_of<FemSpec>().fields)
            if (!is_built || ics.body != BodyShape::block || field.name != "L_over_h") result.erase(field.name);
    if (!is_built) result.erase("accuracy");
    if (!is_built || ics.section) result.erase("any_nu");
    return result;
}

Ics decode_ics(const json& source) {
    return decode_ics(source, {});
}

Ics decode_ics(const json& source, const Frames& frames) {
    Ics ics;
    read_fields(source, ics, MemberPath("ics"), {frames});
    const FemSpec given = std::exchange(ics.fem, {});
    if (ics.source == IcSource::analytic) {
        ics.accuracy = 0;
        ics.any_nu = false;
    } else if (!source.contains("accuracy") && names_a_mesh(source, ics.body)) {
        ics.fem = base_mesh(source, ics.body);
        decode_fem(source, ics.fem);
    } else {
        ics.accuracy = source.value("accuracy", default_accuracy);
        ics.fem.L_over_h = given.L_over_h;
    }
    return ics;
}

}  // namespace contactd::proto
