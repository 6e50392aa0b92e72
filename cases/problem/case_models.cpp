#include "case_models.hpp"

#include <cmath>
#include <string>

#include "types/number_text.hpp"

namespace contactd::cases {
namespace {

enum Bound { from_pressures = 0, elliptic = 2, parabolic = 3, half_ellipses = 4, kpec = 5, analyn = 6 };
enum Bodies { elastic = 0, viscoelastic = 1, fastsim = 3, layered = 4, fastrip = 5 };

}  // namespace

CaseModels models_of(const Given& settings) {
    const int bound = settings.digits.bound, bodies = settings.digits.material;
    CaseModels found;
    if (bound == kpec) found.normal_model = NormalModel::kpec;
    if (bound == analyn) found.normal_model = NormalModel::analyn;
    if (bound == half_ellipses) found.normal_model = NormalModel::elliptic;
    const bool is_plain = bound == elliptic || bound == parabolic;
    const bool is_simplified = bodies == fastsim || bodies == fastrip;
    if (!is_simplified || settings.digits.tangential == 0) {
        if (is_plain) found.normal_model = bound == elliptic ? NormalModel::elliptic : NormalModel::parabolic;
        return found;
    }
    if (bodies == fastrip && bound == parabolic)
        throw NotCovered(Subject::input,
                         "Control digit B = 3 (flag 1971) is not supported with M = 5: FaStrip has no parabolic bound. "
                         "Use B = 2.");
    found.model = bodies == fastsim ? Model::fastsim : Model::fastrip;
    found.simplified.slope = settings.slope;
    found.simplified.blended = true;
    found.simplified.coefficients = CreepageCoefficients::printed;
    if (bodies != fastsim) return found;
    found.simplified.on_elements = true;
    if (bound == elliptic || bound == from_pressures) found.simplified.bound = TractionBound::elliptic;
    return found;
}

MaterialPair solved_materials(const MaterialPair& given) {
    constexpr double alike = 1e-4;
    const auto& [upper, lower] = given;
    if (upper == lower) return given;
    const double G = 2 / (1 / upper.G + 1 / lower.G);
    const double K = G / 4 * ((1 - 2 * upper.nu) / upper.G - (1 - 2 * lower.nu) / lower.G);
    if (!(std::abs(K) < alike)) return given;
    const Material combined{G, G * (upper.nu / upper.G + lower.nu / lower.G) / 2};
    return {combined, combined};
}

std::optional<InterfacialLayer> layer_of(const Given& settings) {
    if (settings.digits.material != layered) return {};
    if (!settings.layer)
        throw NotCovered(
            Subject::input,
            "Control digit M = 4 (flag 1979) requires an interfacial layer, but none was given (method 4 of "
            "cntc_setmaterialparameters).");
    return settings.layer;
}

std::optional<std::array<Viscoelasticity, 2>> creep_of(const Given& settings) {
    if (settings.digits.material != viscoelastic) return {};
    if (!settings.creep)
        throw NotCovered(
            Subject::input,
            "Control digit M = 1 (flag 1979) requires the creep of both bodies, but none was given (method "
            "1 of cntc_setmaterialparameters).");
    return settings.creep;
}

void forget_memory(std::optional<KineticFriction>& kinetic, Model model) {
    if (model != Model::full && kinetic) kinetic->memory.reset();
}

std::string warning_of_memory(const Given& settings) {
    if (!settings.friction || !settings.friction->law.kinetic || models_of(settings).model == Model::full) return {};
    const auto& memory = settings.friction->law.kinetic->memory;
    if (!memory) return {};
    return "MEMDST = " + number_text(memory->distance) +
           " mm has no effect: FASTSIM and FaStrip use one friction coefficient for the whole contact, without memory.";
}

}  // namespace contactd::cases
