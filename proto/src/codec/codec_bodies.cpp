// Encodes and decodes `bodies` and `ics` of a request: coefficients of each body, or a shorthand for both.
#include "codec_parts.hpp"
#include "codec_section.hpp"
#include "contactd/fields/body.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

bool is_table(const json& ics) {
    return ics["source"] == "table";
}

bool is_layered(const json& ics) {
    return ics.value("body", "") == name_of(BodyShape::layered);
}

// Simplified models ignore coefficients, except a line contact, which describes the contact. A section describes the
// body and is refused.
Ics ics_of_simplified_model(const json* ics) {
    Ics result;
    if (ics == nullptr) return result;
    if (ics->value("body", "") == name_of(BodyShape::longitudinally_uniform))
        throw invalid_field(
            "model", "is a closed form, which supports half-spaces only, but a body has a section: use model full");
    if (ics->contains("line_contact"))
        result.line_contact = LineContactSpec{(*ics)["line_contact"]["datum"].get<double>()};
    return result;
}

/// Returns the common source of both bodies; null if they have different sources, tables or layers.
const Ics* shared_source(const Bodies& bodies) {
    const Ics* upper = bodies.upper.computed();
    const Ics* lower = bodies.lower.computed();
    if (bodies.any_given() || bodies.any_layered()) return nullptr;
    if (upper == nullptr || lower == nullptr) return upper != nullptr ? upper : lower;
    return *upper == *lower ? upper : nullptr;
}

json encode_coefficients(const Body& body, ArrayWriter& arrays) {
    if (const GivenIcs* given = body.given()) return encode_given_ics(*given, arrays);
    return encode_ics(std::get<Ics>(body.ics));
}

json encode_body(const Body& body, bool with_ics, ArrayWriter& arrays) {
    if (body.material.is_rigid()) return {{"rigid", true}};
    json result = body.layered() != nullptr ? json::object() : encode_material(body.material);
    if (body.viscoelastic) result["viscoelastic"] = write_fields(*body.viscoelastic, MemberPath("viscoelastic"));
    if (with_ics || body.layered() != nullptr) result["ics"] = encode_coefficients(body, arrays);
    return result;
}

Coefficients decode_coefficients(const json& ics, const Frames& frames, const Grid& grid, const std::string& field) {
    if (is_table(ics)) return decode_given_ics(ics, frames, grid, field);
    return decode_ics(ics, frames);
}

/// `shorthand` is the source of both bodies, or null.
Body decode_body(const json& source, const json* shorthand, const std::string& field, const Frames& frames,
                 const ContactSetup& setup) {
    Body body;
    if (source.contains("rigid")) {
        body.material = Material::rigid();
        return body;
    }
    if (source.contains("ics") && is_layered(source["ics"])) {  // also for simplified models, which refuse layers
        const Ics ics = decode_ics(source["ics"], frames);
        body.material = ics.layered->surface();
        body.ics = ics;
        return body;
    }
    body.material = decode_material(source);
    if (source.contains("viscoelastic"))
        read_fields(source["viscoelastic"], body.viscoelastic.emplace(), MemberPath(MemberPath(field), "viscoelastic"));
    if (setup.model != Model::full) {
        body.ics = ics_of_simplified_model(source.contains("ics") ? &source["ics"] : shorthand);
        return body;
    }
    if (source.contains("ics"))
        body.ics = decode_coefficients(source["ics"], frames, setup.grid, field + ".ics");
    else if (shorthand != nullptr)
        body.ics = decode_ics(*shorthand, frames);
    else
        throw invalid_field(field + ".ics",
                            "is missing, and so is ics, which applies to both bodies; give one of them to choose the "
                            "influence coefficients");
    return body;
}

bool brings_ics(const json& bodies) {
    for (const char* body : {"upper", "lower"})
        if (bodies.contains(body) && bodies[body].contains("ics")) return true;
    return false;
}

}  // namespace

void encode_bodies(const ContactSetup& setup, json& params, ArrayWriter& arrays) {
    const Bodies& bodies = setup.bodies;
    const bool full = setup.model == Model::full;
    if (full && bodies.pair) {
        params["ics"] = encode_given_ics(*bodies.pair, arrays);
        return;
    }
    const Ics* both = shared_source(bodies);
    const bool apart = full && both == nullptr;
    params["bodies"] = object({{"upper", encode_body(bodies.upper, apart, arrays)}});
    if (apart || bodies.lower.material != bodies.upper.material ||
        bodies.lower.viscoelastic != bodies.upper.viscoelastic || bodies.any_layered())
        params["bodies"]["lower"] = encode_body(bodies.lower, apart, arrays);
    if (full && both != nullptr) params["ics"] = encode_ics(*both);
    if (const auto line = line_contact_of(bodies); !full && line) {
        Ics of_lines;
        of_lines.line_contact = line;
        params["ics"] = encode_ics(of_lines);
    }
}

void decode_bodies(const json& params, const Frames& frames, ContactSetup& setup) {
    const json* ics = params.contains("ics") ? &params["ics"] : nullptr;
    if (setup.model == Model::full && ics != nullptr && is_table(*ics)) {
        if (params.contains("bodies") && brings_ics(params["bodies"]))
            throw invalid_field("ics.table", "applies to both bodies, but a body has its own ics; remove one of them");
        setup.bodies.pair = decode_given_ics(*ics, frames, setup.grid, "ics");
        return;
    }
    if (ics != nullptr && is_layered(*ics))
        throw invalid_field(
            "ics.body", "is layered, but layers belong to one body: give them as bodies.upper.ics or bodies.lower.ics");
    const json& bodies = params["bodies"];
    setup.bodies.upper = decode_body(bodies["upper"], ics, "bodies.upper", frames, setup);
    setup.bodies.lower = bodies.contains("lower") ? decode_body(bodies["lower"], ics, "bodies.lower", frames, setup)
                                                  : setup.bodies.upper;
}

}  // namespace contactd::proto
