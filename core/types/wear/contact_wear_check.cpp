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
        throw InvalidArgument("friction.rolling.kind",
                              "is transient, and wear is given; what a passage takes off is that of steady rolling");
    if (!rolls_along_x(rolling.chi))
        throw InvalidArgument("friction.rolling.chi",
                              "is " + number_text(rolling.chi) +
                                  ", and wear is given; what a passage takes off is that of rolling along x, 0 or pi, "
                                  "in which each point of the surface stays in its row of elements");
    if (rolling.velocity != Rolling{}.velocity) return;
    for (const WearLaw& law : wear.laws)
        if (needs_velocity(law))
            throw InvalidArgument("friction.rolling.velocity",
                                  "is 1 mm/s, as where it is left out, and the law " + law.name +
                                      " of wear depends on the sliding velocity; give the velocity of rolling");
}

}  // namespace

void check_wear_model(Model model) {
    if (model == Model::hertz || model == Model::polach)
        throw InvalidArgument("model", "is " + std::string(name_of(model)) +
                                           ", and wear is given; it is that of the slip of each element, which this "
                                           "model does not tell: take full or fastsim");
}

void check_wear_layer(const std::optional<InterfacialLayer>& layer) {
    if (layer && layer->yields())
        throw InvalidArgument("friction.layer.yield_stress",
                              "is given, and wear, too; what a layer that flows takes off the surfaces is not known: "
                              "leave one of them out");
}

void check_wear(const ContactProblem& problem, bool complete) {
    if (!problem.wear) return;
    validate(*problem.wear, "wear");
    check_wear_model(problem.model);
    if (!problem.friction && complete)
        throw InvalidArgument("wear", "is given, and friction is not; wear is that of rolling contact with friction");
    if (!problem.friction) return;
    check_wear_layer(problem.friction->layer);
    if (problem.bodies.any_viscoelastic() && problem.wear->energy == WearEnergy::scaled)
        throw InvalidArgument("wear.energy",
                              "is scaled, and a body is viscoelastic, whose creep takes energy, too, so that forces "
                              "and creepages do not tell that of the slip: take plain");
    if (std::holds_alternative<Shift>(problem.motion))
        throw InvalidArgument("wear",
                              "is given, and friction has a shift; what a passage takes off is that of steady rolling: "
                              "give friction.rolling, or leave wear out");
    check_rolling(std::get<Rolling>(problem.motion), *problem.wear);
}

}  // namespace contactd
