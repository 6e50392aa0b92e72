// Checks which options each simplified model supports.
#include <string>

#include "contactd/contact_setup.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/contact_setup.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

[[noreturn]] void not_of(const ContactSetup& setup, const char* field, const std::string& value, const char* models) {
    throw InvalidArgument(std::string("simplified.") + field,
                          "is " + value + ", which applies to " + models + " only, but model is " +
                              std::string(name_of(setup.model)) + ": remove it, or use another model");
}

void check_reductions(const SimplifiedSettings& settings) {
    if (settings.k_slip > settings.k_adhesion)
        throw InvalidArgument("simplified.k_slip", "is " + number_text(settings.k_slip) + " and k_adhesion is " +
                                                       number_text(settings.k_adhesion) +
                                                       "; Polach's theory requires k_slip <= k_adhesion");
}

}  // namespace

void validate_models(const ContactSetup& setup) {
    const SimplifiedSettings& settings = setup.simplified;
    const bool fastsim = setup.model == Model::fastsim, strips = setup.model == Model::fastrip;
    const bool polach = setup.model == Model::polach;
    if (settings.slope != SlopeReduction{} && !fastsim && !strips)
        not_of(setup, "slope", "given", "models fastsim and fastrip");
    if (settings.bound == TractionBound::elliptic && !fastsim) not_of(setup, "bound", "elliptic", "model fastsim");
    if (settings.on_elements && !fastsim) not_of(setup, "on_elements", "true", "model fastsim");
    if (settings.blended && !fastsim && !strips) not_of(setup, "blended", "true", "models fastsim and fastrip");
    if (settings.coefficients == CreepageCoefficients::printed && !fastsim && !strips && !polach)
        not_of(setup, "coefficients", "printed", "models fastsim, fastrip and polach");
    if (settings.k_adhesion != 1 && !polach)
        not_of(setup, "k_adhesion", number_text(settings.k_adhesion), "model polach");
    if (settings.k_slip != 1 && !polach) not_of(setup, "k_slip", number_text(settings.k_slip), "model polach");
    check_reductions(settings);
    if (setup.normal_model != NormalModel::of_model && setup.model == Model::hertz)
        throw InvalidArgument("normal_model",
                              "cannot be combined with model hertz, which has its own pressures; use model full, "
                              "fastsim, fastrip or polach, or remove normal_model");
}

}  // namespace contactd
