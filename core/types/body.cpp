#include "contactd/body.hpp"

#include <array>
#include <string>
#include <tuple>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "number_text.hpp"
#include "types/ics/row_of_layers.hpp"

namespace contactd {
namespace {

constexpr double largest_creep = 1e6;

bool takes_incompressible(const Body& body) {
    const Ics* ics = body.computed();
    return ics == nullptr || ics->source == IcSource::analytic;
}

/// A pair of elements carries one traction, so its shape must be the same for both bodies.
void check_agreement(const Bodies& bodies) {
    const Ics* upper = bodies.upper.computed();
    const Ics* lower = bodies.lower.computed();
    if (upper != nullptr && lower != nullptr) {
        if (upper->load_shape != lower->load_shape)
            throw InvalidArgument("bodies.lower.ics.load_shape",
                                  "is " + std::string(name_of(lower->load_shape)) + ", but that of the upper body is " +
                                      std::string(name_of(upper->load_shape)) +
                                      "; both bodies carry the same tractions, so their load shapes must be equal");
        for (const auto& [ics, field] :
             {std::pair(upper, "bodies.upper.ics.line_contact"), std::pair(lower, "bodies.lower.ics.line_contact")})
            if (ics->line_contact && bodies.any_layered()) throw InvalidArgument(field, row_of_layers);
        if (upper->line_contact != lower->line_contact)
            throw InvalidArgument("bodies.lower.ics.line_contact",
                                  "differs from that of the upper body; either both bodies have a line contact, with "
                                  "the same datum, or neither");
    }
    if (!bodies.any_given()) return;
    for (const auto& [ics, field] :
         {std::pair(upper, "bodies.upper.ics.line_contact"), std::pair(lower, "bodies.lower.ics.line_contact")})
        if (ics != nullptr && ics->line_contact)
            throw InvalidArgument(field,
                                  "cannot be combined with a table of the other body; a line contact needs computed "
                                  "coefficients of both bodies, or a table of the pair");
}

void check_creep(const Body& body, const std::string& field) {
    if (!body.viscoelastic) return;
    if (body.material.is_rigid()) throw InvalidArgument(field, "is given, but a rigid body does not creep: remove it");
    const auto [f, tau] = *body.viscoelastic;
    for (const auto& [value, name, most] : {std::tuple(f, ".f", largest_creep), std::tuple(tau, ".tau", 1e100)})
        if (!(value >= 0 && value <= most))
            throw InvalidArgument(field + name,
                                  "is " + number_text(value) + "; it must lie in [0, " + number_text(most) + "]");
}

/// Coefficients of a viscoelastic body are only available for half-spaces in closed form; the other body must be one,
/// too.
void check_half_space(const Body& body, const std::string& field) {
    if (body.material.is_rigid()) return;
    const std::string why =
        body.viscoelastic ? ", but the body is viscoelastic" : ", but the other body is viscoelastic";
    const Ics* ics = body.computed();
    if (ics == nullptr) throw InvalidArgument(field, "is a table" + why + "; use source analytic");
    if (ics->body != BodyShape::half_space)
        throw InvalidArgument(field + ".body", "is " + std::string(name_of(ics->body)) + why +
                                                   "; use half_space, or remove viscoelastic");
    if (ics->source != IcSource::analytic)
        throw InvalidArgument(field + ".source", "is fem" + why + "; use analytic, the closed form");
}

}  // namespace

const GivenIcs* Body::given() const {
    return material.is_rigid() ? nullptr : std::get_if<GivenIcs>(&ics);
}

const Ics* Body::computed() const {
    return material.is_rigid() ? nullptr : std::get_if<Ics>(&ics);
}

const Layers* Body::layered() const {
    const Ics* source = computed();
    return source != nullptr && source->layered ? &*source->layered : nullptr;
}

const Section* Body::section() const {
    const Ics* source = computed();
    return source != nullptr && source->section ? &*source->section : nullptr;
}

Body Body::of(const Layers& layers, LoadShape load_shape) {
    Ics source;
    source.body = BodyShape::layered;
    source.load_shape = load_shape;
    source.layered = layers;
    return {layers.layers.empty() ? Material{} : layers.surface(), source};
}

bool Bodies::any_layered() const {
    return !pair && (upper.layered() != nullptr || lower.layered() != nullptr);
}

bool Bodies::any_viscoelastic() const {
    return !pair && (upper.viscoelastic || lower.viscoelastic);
}

bool Bodies::any_uniform() const {
    return !pair && (upper.section() != nullptr || lower.section() != nullptr);
}

bool Bodies::any_given() const {
    return pair || upper.given() != nullptr || lower.given() != nullptr;
}

Bodies without_instant_creep(Bodies bodies) {
    for (Body* body : {&bodies.upper, &bodies.lower}) {
        if (!body->viscoelastic || (body->viscoelastic->f > 0 && body->viscoelastic->tau > 0)) continue;
        if (body->viscoelastic->tau == 0) body->material.G /= 1 + body->viscoelastic->f;
        body->viscoelastic.reset();
    }
    return bodies;
}

std::optional<LineContactSpec> line_contact_of(const Bodies& bodies) {
    if (bodies.pair) return {};
    for (const Body* body : {&bodies.upper, &bodies.lower})
        if (const Ics* ics = body->computed(); ics != nullptr && ics->line_contact) return ics->line_contact;
    return {};
}

void validate(const Bodies& bodies, const Grid& grid) {
    if (bodies.pair) return validate(*bodies.pair, grid, "ics");
    const std::array named{std::pair("bodies.upper", &bodies.upper), std::pair("bodies.lower", &bodies.lower)};
    for (const auto& [name, body] : named) {
        if (const Layers* layers = body->layered()) validate(*layers, grid.dx, (std::string(name) + ".ics").c_str());
        if (!body->material.is_rigid()) validate(body->material, name, takes_incompressible(*body));
    }
    if (bodies.upper.material.is_rigid() && bodies.lower.material.is_rigid())
        throw InvalidArgument("bodies.lower", "is rigid, and so is bodies.upper; one of them must be elastic");
    for (const auto& [name, body] : named)
        if (const GivenIcs* given = body->given()) validate(*given, grid, std::string(name) + ".ics");
    check_agreement(bodies);
    for (const auto& [name, body] : named) {
        check_creep(*body, std::string(name) + ".viscoelastic");
        if (bodies.any_viscoelastic()) check_half_space(*body, std::string(name) + ".ics");
    }
}

}  // namespace contactd
