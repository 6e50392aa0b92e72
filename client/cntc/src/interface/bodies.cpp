// Materials of the bodies, the layer and the friction between them.
#include <algorithm>
#include <array>
#include <optional>

#include "interface/entry.hpp"
#include "problem/given_friction.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

/// Methods of materials, and of damping beside them.
enum Method {
    elastic = 0,
    viscoelastic = 1,
    fastsim = 3,
    layered = 4,
    fastrip = 5,
    undamped = 10,
    keeps_damping = 11,
    damped = 12
};

MaterialPair materials_of(const std::vector<double>& given, const Units& units) {
    const MaterialPair pair{{given[2] * units.stress(), given[0]}, {given[3] * units.stress(), given[1]}};
    validate(pair.upper, "body 1", true);
    validate(pair.lower, "body 2", true);
    return pair;
}

/// The layer has the flexibility thickness/gg3; tau_c0 = 0 or 1e10 N/mm^2 and more never yields.
InterfacialLayer layer_of(const std::vector<double>& given, const Units& units) {
    constexpr double never = 1e10;
    const double gg3 = given[4], thickness = given[5], tau_c0 = given[6] * units.stress(), k_tau = given[7];
    if (!(gg3 > 0) || !(thickness >= 0) || !(tau_c0 >= 0))
        throw Refused(error_code::input, "An interfacial layer requires gg3 > 0, laythk >= 0 and tau_c0 >= 0.");
    InterfacialLayer layer{thickness * units.length / (gg3 * units.stress())};
    if (tau_c0 == 0 || tau_c0 >= never) return layer;
    layer.yield_stress = tau_c0;
    layer.hardening = k_tau * units.stress() / units.length;
    validate(layer);
    return layer;
}

/// [fg1, fg2, tc1, tc2], the last two in s.
std::array<Viscoelasticity, 2> creep_of(const std::vector<double>& given) {
    const std::array<Viscoelasticity, 2> bodies{{{given[4], given[6]}, {given[5], given[7]}}};
    for (const auto& [f, tau] : bodies)
        if (!(f >= 0 && tau >= 0))
            throw Refused(error_code::input, "Viscoelastic bodies require fg1, fg2, tc1 and tc2 of at least 0.");
    return bodies;
}

/// Nothing is reduced at large creepages where k0 is not, whatever beta is. The program takes an alpha of 0 as 1e-6.
SlopeReduction slope_of(const std::vector<double>& given) {
    constexpr double least_alpha = 1e-6;
    const double k0 = given[4], alpha = given[5], beta = given[6];
    if (!(k0 > 0 && alpha >= 0 && beta >= 0))
        throw Refused(error_code::input, "A reduction of the slope requires k0 > 0, alpha >= 0 and beta >= 0.");
    return {k0, std::max(alpha, least_alpha), beta};
}

/// Throws Refused where there is damping: contactd has none.
void set_damping(Settings& settings, int method, const double* rparam, const int* nparam) {
    if (method == undamped) return;
    if (method == keeps_damping) {
        if (const auto refused = settings.refused.find("damping"); refused != settings.refused.end())
            throw refused->second;
        return;
    }
    const auto given = list(rparam, nparam, 4, "rparam");
    if (given[0] != 0 || given[1] != 0)
        throw Refused(error_code::input,
                      "Damping (method 12) is not supported unless cdampn and cdampt are 0. Set them to 0, or call "
                      "cntc_setmaterialparameters with method 10.");
}

void set_material(Settings& settings, int method, const double* rparam, const int* nparam) {
    const bool is_simplified = method == fastsim || method == fastrip,
               has_eight = method == viscoelastic || method == layered;
    if (method != elastic && !has_eight && !is_simplified)
        throw Refused(error_code::input,
                      "Material method " + std::to_string(method) +
                          " is not supported; use 0 for elastic bodies, 1 for viscoelastic ones, 3 or 5 for the "
                          "simplified theory, 4 for an interfacial layer, or 10, 11 or 12 for damping.");
    std::vector<double> given = list(rparam, nparam, is_simplified ? 7 : has_eight ? 8 : 4, "rparam");
    settings.slope = {};
    settings.layer.reset();
    settings.creep.reset();
    if (method == viscoelastic) settings.creep = creep_of(given);
    if (method == layered) settings.layer = layer_of(given, settings.units);
    if (is_simplified) settings.slope = slope_of(given);
    settings.materials = materials_of(given, settings.units);
    settings.digits.set(flag::material, method);
    settings.refused.erase("flag " + std::to_string(flag::material));
}

}  // namespace

extern "C" void cntc_setmaterialparameters(int* ire, int* icp, int* imeth, int* nparam, double* rparam) {
    const bool is_damping = imeth != nullptr && *imeth >= undamped && *imeth <= damped;
    set("cntc_setmaterialparameters", ire, icp, is_damping ? "damping" : "material", [&](Settings& settings) {
        const int method = integer(imeth, "imeth");
        (is_damping ? set_damping : set_material)(settings, method, rparam, nparam);
    });
}
CONTACTD_FORTRAN_NAME(cntc_setmaterialparameters)

extern "C" void cntc_setfrictionmethod(int* ire, int* icp, int* imeth, int* nparam, double* params) {
    set("cntc_setfrictionmethod", ire, icp, "friction", [&](Settings& settings) {
        const int method = integer(imeth, "imeth");
        const bool keeps = method >= 0 && method % 10 == keeps_friction;  // whatever it says of places
        if (keeps && settings.friction) return;
        settings.friction = read_friction(method, params, nparam, settings);
        settings.digits.set(flag::friction_law, settings.friction->method % 10);
        settings.refused.erase("flag " + std::to_string(flag::friction_law));
    });
}
CONTACTD_FORTRAN_NAME(cntc_setfrictionmethod)
