#include "contact_fatigue_check.hpp"

#include <string>
#include <variant>

#include "contactd/error.hpp"
#include "contactd/fields/contact.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

void check_rolls_along_x(const Rolling& rolling) {
    if (!rolling.steady())
        throw InvalidArgument(
            "friction.rolling.kind",
            "is transient, and fatigue is given; the history of a particle is that of steady rolling");
    if (!rolls_along_x(rolling.chi))
        throw InvalidArgument("friction.rolling.chi",
                              "is " + number_text(rolling.chi) +
                                  ", and fatigue is given; the history of a particle is a row of elements where the "
                                  "bodies roll along x, 0 or pi");
}

void check_has_stresses(const Bodies& bodies, WornBody which) {
    const std::string name = which == WornBody::upper ? "upper" : "lower";
    const Body& body = which == WornBody::upper ? bodies.upper : bodies.lower;
    const Ics* ics = body.computed();
    if (!bodies.pair && body.material.is_rigid())
        throw InvalidArgument("fatigue.body", "is " + name + ", which is rigid; take the other body");
    if (bodies.pair || ics == nullptr)
        throw InvalidArgument("fatigue.passage",
                              "is given, and the coefficients of bodies." + name +
                                  " are a table of the request, which says nothing of what is below its surface");
    if (ics->body == BodyShape::block)
        throw InvalidArgument(
            "fatigue.passage",
            "is given, and bodies." + name + " is a block; the closed form of the stresses is that of the half-space");
}

}  // namespace

void check_fatigue_model(Model model) {
    if (model == Model::hertz || model == Model::polach)
        throw InvalidArgument("model", "is " + std::string(name_of(model)) +
                                           ", and fatigue is given; it is that of the tractions of each element, which "
                                           "this model does not tell: take full or fastsim");
}

void check_fatigue(const ContactProblem& problem, bool complete) {
    if (!problem.fatigue) return;
    validate(*problem.fatigue, "fatigue");
    check_fatigue_model(problem.model);
    if (problem.fatigue->passage) check_has_stresses(problem.bodies, problem.fatigue->body);
    if (!problem.friction && complete)
        throw InvalidArgument("fatigue",
                              "is given, and friction is not; it is that of rolling contact with friction, which may "
                              "be small");
    if (!problem.friction) return;
    if (std::holds_alternative<Shift>(problem.motion))
        throw InvalidArgument(
            "fatigue",
            "is given, and friction has a shift; the history of a particle is that of steady rolling: "
            "give friction.rolling, or leave fatigue out");
    check_rolls_along_x(std::get<Rolling>(problem.motion));
}

}  // namespace contactd
