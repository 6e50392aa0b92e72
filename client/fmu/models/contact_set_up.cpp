#include "set_up.hpp"

#include <string>
#include <string_view>

#include "variables/contact_variables.hpp"

namespace contactd::fmu {
namespace {

consteval std::size_t at(std::string_view name) {
    return reference_of(contact_variables, name);
}

/// Holds positions of a body's variables in the list, and the path of the body.
struct BodyPlaces {
    std::string_view path;
    std::size_t G, nu, rigid, coefficients, thickness, layer_G, layer_nu;
};
constexpr BodyPlaces bodies[] = {
    {"bodies.upper", at("upper.G"), at("upper.nu"), at("upper.rigid"), at("upper.coefficients"),
     at("upper.layer.thickness"), at("upper.layer.G"), at("upper.layer.nu")},
    {"bodies.lower", at("lower.G"), at("lower.nu"), at("lower.rigid"), at("lower.coefficients"),
     at("lower.layer.thickness"), at("lower.layer.G"), at("lower.layer.nu")},
};

void set_material(contactd_contact* c, const Values& values, const BodyPlaces& of, const std::string& path) {
    set_field(c, path + ".G", values[of.G]);
    set_field(c, path + ".nu", values[of.nu]);
}

void set_up_body(contactd_contact* c, const Values& values, const BodyPlaces& of) {
    const std::string body(of.path), ics = body + ".ics";
    if (values.is(of.rigid)) return set_field(c, body + ".rigid", 1);
    const int kind = values.whole(of.coefficients);
    if (kind == 3) {
        set_keyword(c, ics + ".body", "layered");
        set_field(c, ics + ".layers[0].thickness", values[of.thickness]);
        set_field(c, ics + ".layers[0].G", values[of.layer_G]);
        set_field(c, ics + ".layers[0].nu", values[of.layer_nu]);
        return set_material(c, values, of, ics + ".base");
    }
    set_material(c, values, of, body);
    if (kind == 4) set_fields(c, values, body + ".viscoelastic.");
    if (kind == 0 || kind == 4) return;
    const bool block = kind == 2;
    set_keyword(c, ics + ".source", "fem");
    set_keyword(c, ics + ".body", block ? "block" : "half_space");
    set_field(c, ics + ".accuracy", values[at("elements.accuracy")]);
    if (block) set_field(c, ics + ".L_over_h", values[at("elements.L_over_h")]);
}

void set_solver(contactd_contact* c, const std::string& name, double tolerance, int max_iterations) {
    set_field(c, "settings." + name + ".tolerance", tolerance);
    set_field(c, "settings." + name + ".max_iterations", max_iterations);
}

}  // namespace

void set_fields(contactd_contact* c, const Values& values, std::string_view group) {
    for (std::size_t at = 0; at < contact_variables.size(); ++at) {
        const Variable& variable = contact_variables[at];
        if (variable.role == Role::output || !variable.path.starts_with(group)) continue;
        if (!variable.zero_is_absent || values[at] != 0) set_field(c, std::string(variable.path), values[at]);
    }
}

void set_up(contactd_contact* c, const Values& values) {
    set_fields(c, values, "grid.");
    for (const BodyPlaces& body : bodies) set_up_body(c, values, body);
    set_keyword(c, "model", keyword_of(contact_variables[at("model")], values[at("model")]));
    set_field(c, "accept_unconverged", values[at("accept_unconverged")]);
    const int most = values.whole(at("tolerances.iterations"));
    set_solver(c, "normal", values[at("tolerances.normal")], most ? most : 1000);
    set_solver(c, "tangential", values[at("tolerances.tangential")], most ? most : 1000);
    set_solver(c, "outer", values[at("tolerances.outer")], most ? most : 100);
    check(contactd_set_step_timeout(c, values[at("limits.step")]), c);
}

}  // namespace contactd::fmu
