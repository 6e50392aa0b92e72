#include "given_bodies.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "given/not_covered.hpp"

namespace contactd::cases {
namespace {

MaterialPair materials_of(const std::vector<double>& given, const Units& units) {
    const MaterialPair pair{{given[2] * units.stress(), given[0]}, {given[3] * units.stress(), given[1]}};
    validate(pair.upper, "body 1", true);
    validate(pair.lower, "body 2", true);
    return pair;
}

/// Returns a layer of the flexibility thickness/gg3. It never yields if tau_c0 is 0, or at least 1e10 N/mm^2.
InterfacialLayer layer_of(const std::vector<double>& given, const Units& units) {
    constexpr double never = 1e10;
    const double gg3 = given[4], thickness = given[5], tau_c0 = given[6] * units.stress(), k_tau = given[7];
    if (!(gg3 > 0) || !(thickness >= 0) || !(tau_c0 >= 0))
        throw NotCovered(Subject::input, "An interfacial layer (M = 4) requires GG3 > 0, LAYTHK >= 0 and TAU_C0 >= 0.");
    InterfacialLayer layer{thickness * units.length / (gg3 * units.stress())};
    if (tau_c0 == 0 || tau_c0 >= never) return layer;
    layer.yield_stress = tau_c0;
    layer.hardening = k_tau * units.stress() / units.length;
    validate(layer);
    return layer;
}

/// Reads the creep of both bodies from [fg1, fg2, tc1, tc2], the last two in s.
std::array<Viscoelasticity, 2> creep_of(const std::vector<double>& given) {
    const std::array<Viscoelasticity, 2> bodies{{{given[4], given[6]}, {given[5], given[7]}}};
    for (const auto& [f, tau] : bodies)
        if (!(f >= 0 && tau >= 0))
            throw NotCovered(Subject::input,
                             "Viscoelastic bodies (M = 1) require FG1, FG2, TC1 and TC2 of at least 0.");
    return bodies;
}

/// Returns the slope reduction. Without a reduction by k0, beta has no effect. CONTACT replaces an alpha of 0 by 1e-6.
SlopeReduction slope_of(const std::vector<double>& given) {
    constexpr double least_alpha = 1e-6;
    const double k0 = given[4], alpha = given[5], beta = given[6];
    if (!(k0 > 0 && alpha >= 0 && beta >= 0))
        throw NotCovered(Subject::input, "FASTSIM and FaStrip (M = 3, 5) require K0 > 0, ALFA >= 0 and BETA >= 0.");
    return {k0, std::max(alpha, least_alpha), beta};
}

ThermalBody thermal_body(const double* values, const Units& units) {
    constexpr double metre = 1000;  // mm
    const double length = metre / units.length;
    ThermalBody body;
    body.bulk_temperature = values[0];
    body.heat_capacity = values[1];
    body.conductivity = values[2] * length;
    body.density = values[3] * length * length * length;
    return body;
}

}  // namespace

std::optional<int> material_numbers(int method) {
    switch (method) {
        case material::elastic:
            return 4;
        case material::fastsim:
        case material::fastrip:
            return 7;
        case material::viscoelastic:
        case material::layered:
            return 8;
        default:
            return std::nullopt;
    }
}

void set_material(Given& given, int method, const std::vector<double>& numbers, const Units& units) {
    given.slope = {};
    given.layer.reset();
    given.creep.reset();
    if (method == material::viscoelastic) given.creep = creep_of(numbers);
    if (method == material::layered) given.layer = layer_of(numbers, units);
    if (method == material::fastsim || method == material::fastrip) given.slope = slope_of(numbers);
    given.materials = materials_of(numbers, units);
}

void require_undamped(double normal, double tangential) {
    if (normal != 0 || tangential != 0)
        throw NotCovered(
            Subject::input,
            "Damping is not supported: CDAMPN and CDAMPT must be 0. Set both to 0, or use M2 = 0 (method 10 "
            "of cntc_setmaterialparameters).");
}

ThermalBodies thermal_bodies(const std::vector<double>& numbers, const Units& units) {
    ThermalBodies bodies{thermal_body(&numbers[0], units), thermal_body(&numbers[4], units)};
    if (numbers.size() > 8) bodies.plastic_share = numbers[8];
    validate(bodies, "heat");
    return bodies;
}

ContactSettings solver_settings(double eps, int maxgs, int maxout) {
    if (!(eps > 0 && eps < 1)) throw NotCovered(Subject::input, "EPS must be larger than 0 and smaller than 1.");
    if (maxgs < 1 || maxout < 1)
        throw NotCovered(Subject::input, "MAXGS = " + std::to_string(maxgs) + ", MAXOUT = " + std::to_string(maxout) +
                                             ": both must be at least 1.");
    const ContactSettings own;
    ContactSettings settings;
    settings.normal.tolerance = std::min(own.normal.tolerance, eps);
    settings.tangential.tolerance = std::min(own.tangential.tolerance, eps);
    settings.outer.tolerance = std::min(own.outer.tolerance, eps);
    settings.normal.max_iterations = settings.tangential.max_iterations = maxgs;
    if (maxout > 1) settings.outer.max_iterations = maxout;
    return settings;
}

}  // namespace contactd::cases
