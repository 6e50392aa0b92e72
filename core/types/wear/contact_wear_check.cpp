#include "contact_wear_check.hpp"

#include <string>
#include <variant>

#include "contactd/error.hpp"
#include "contactd/fields/contact.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

void check_rolling(const Rolling& rolling, const WearRequest& wear) {
    if (!rolling.steady())
        throw InvalidArgument("friction.rolling.kind", "is transient, but wear requires steady rolling");
    if (!rolls_along_x(rolling.chi))
        throw InvalidArgument("friction.rolling.chi", "is " + number_text(rolling.chi) +
                                                          ", but wear requires rolling along x, in which each point of "
                                                          "the surface stays in its row of elements: use 0 or pi");
    if (rolling.velocity != Rolling{}.velocity) return;
    for (const WearLaw& law : wear.laws)
        if (needs_velocity(law))
            throw InvalidArgument("friction.rolling.velocity",
                                  "is 1 mm/s, the default, but the wear law " + law.name +
                                      " depends on the sliding velocity; give the velocity of rolling");
}

}  // namespace

void check_wear_model(Model model) {
    if (model == Model::hertz || model == Model::polach)
        throw InvalidArgument(
            "model",
            "is " + std::string(name_of(model)) +
                ", but wear requires the slip of each element, which this model does not compute: use full or fastsim");
}

void check_wear_layer(const std::optional<InterfacialLayer>& layer) {
    if (layer && layer->yields())
        throw InvalidArgument("friction.layer.yield_stress",
                              "cannot be combined with wear, because the wear under a yielding layer is not modelled: "
                              "remove one of them");
}

void check_wear(const ContactProblem& problem, bool complete) {
    if (!problem.wear) return;
    validate(*problem.wear, "wear");
    check_wear_model(problem.model);
    if (!problem.friction && complete)
        throw InvalidArgument("wear", "requires rolling contact with friction: give friction, or remove wear");
    if (!problem.friction) return;
    check_wear_layer(problem.friction->layer);
    if (problem.bodies.any_viscoelastic() && problem.wear->energy == WearEnergy::scaled)
        throw InvalidArgument("wear.energy",
                              "is scaled, but the creep of a viscoelastic body also dissipates energy, so forces and "
                              "creepages do not determine that of the slip: use plain");
    if (std::holds_alternative<Shift>(problem.motion))
        throw InvalidArgument(
            "wear", "requires steady rolling, but friction has a shift: give friction.rolling, or remove wear");
    check_rolling(std::get<Rolling>(problem.motion), *problem.wear);
}

}  // namespace contactd
