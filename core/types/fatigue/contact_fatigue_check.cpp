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
        throw InvalidArgument("friction.rolling.kind",
                              "is transient, but fatigue requires steady rolling, in which a row of elements is the "
                              "history of a particle");
    if (!rolls_along_x(rolling.chi))
        throw InvalidArgument("friction.rolling.chi", "is " + number_text(rolling.chi) +
                                                          ", but fatigue requires rolling along x, in which a row of "
                                                          "elements is the history of a particle: use 0 or pi");
}

void check_has_stresses(const Bodies& bodies, WornBody which) {
    const std::string name = which == WornBody::upper ? "upper" : "lower";
    const Body& body = which == WornBody::upper ? bodies.upper : bodies.lower;
    const Ics* ics = body.computed();
    if (!bodies.pair && body.material.is_rigid())
        throw InvalidArgument("fatigue.body", "is " + name + ", which is rigid; use the other body");
    if (bodies.pair || ics == nullptr)
        throw InvalidArgument(
            "fatigue.passage",
            "is given, but the coefficients of bodies." + name +
                " are a table in the request, which does not describe the body below its surface: compute them");
    if (ics->body == BodyShape::block)
        throw InvalidArgument(
            "fatigue.passage",
            "is given, but bodies." + name + " is a block, for which stresses below the surface are not available");
}

}  // namespace

void check_fatigue_model(Model model) {
    if (model == Model::hertz || model == Model::polach)
        throw InvalidArgument("model", "is " + std::string(name_of(model)) +
                                           ", but fatigue requires the tractions of each element, which this model "
                                           "does not compute: use full or fastsim");
}

void check_fatigue(const ContactProblem& problem, bool complete) {
    if (!problem.fatigue) return;
    validate(*problem.fatigue, "fatigue");
    check_fatigue_model(problem.model);
    if (problem.fatigue->passage) check_has_stresses(problem.bodies, problem.fatigue->body);
    if (!problem.friction && complete)
        throw InvalidArgument(
            "fatigue",
            "requires rolling contact with friction: give friction, whose coefficient may be small, or remove fatigue");
    if (!problem.friction) return;
    if (std::holds_alternative<Shift>(problem.motion))
        throw InvalidArgument(
            "fatigue", "requires steady rolling, but friction has a shift: give friction.rolling, or remove fatigue");
    check_rolls_along_x(std::get<Rolling>(problem.motion));
}

}  // namespace contactd
