#include "contact_temperature_check.hpp"

#include <string>
#include <utility>
#include <variant>

#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

void check_rolling(const Rolling& rolling) {
    if (!rolling.steady())
        throw InvalidArgument("friction.rolling.kind", "is transient, but temperature requires steady rolling");
    if (!rolls_along_x(rolling.chi))
        throw InvalidArgument(
            "friction.rolling.chi",
            "is " + number_text(rolling.chi) +
                ", but temperature requires rolling along x, in which heat stays in its row of elements: use 0 or pi");
    if (rolling.velocity == Rolling{}.velocity)
        throw InvalidArgument(
            "friction.rolling.velocity",
            "is 1 mm/s, the default, but temperature requires the velocity of rolling: give it in mm/s");
}

void check_elements(const Bodies& bodies) {
    for (const auto& [body, name] : {std::pair{&bodies.upper, "upper"}, std::pair{&bodies.lower, "lower"}})
        if (const Ics* ics = body->computed(); ics != nullptr && ics->load_shape == LoadShape::bilinear)
            throw InvalidArgument(
                std::string("bodies.") + name + ".ics.load_shape",
                "is bilinear, but temperature requires elements with constant tractions: use constant");
}

/// Checks the law of each row with the coefficients of that row.
void check_rows(const ContactProblem& problem) {
    const FrictionLaw& friction = *problem.friction;
    const std::size_t nx = static_cast<std::size_t>(problem.grid.nx), ny = static_cast<std::size_t>(problem.grid.ny);
    if (friction.temperature || friction.temperature_of_rows.size() != ny)
        throw InvalidArgument("friction.temperature_of_rows",
                              "has " + std::to_string(friction.temperature_of_rows.size()) +
                                  " entries; it needs one for each of the " + std::to_string(ny) +
                                  " rows of the grid, in place of friction.temperature");
    for (std::size_t row = 0; row < ny; ++row)
        for (std::size_t i = row * nx; i < (row + 1) * nx; ++i) {
            const double mu = friction.mu_of(i);
            validate(friction.temperature_of_rows[row], {&mu, 1});
        }
}

void check_law(const ContactProblem& problem) {
    const FrictionLaw& friction = *problem.friction;
    if (!problem.temperature)
        throw InvalidArgument(
            "friction.temperature",
            "requires the thermal properties of the bodies: give temperature, or remove friction.temperature");
    if (friction.temperature) validate(*friction.temperature, friction.mu);
    if (!friction.temperature_of_rows.empty()) check_rows(problem);
    if (problem.model != Model::full)
        throw InvalidArgument("friction.temperature", "is not supported by simplified models: use model full");
    if (friction.kinetic)
        throw InvalidArgument("friction.temperature",
                              "cannot be combined with friction.kinetic, because friction depends either on the "
                              "temperature or on the slip velocity: remove one of them");
    if (problem.derivatives)
        throw InvalidArgument("derivatives",
                              "are not available if friction depends on the temperature; remove friction.temperature, "
                              "or use finite differences of solves");
}

}  // namespace

void check_temperature(const ContactProblem& problem, bool complete) {
    if (problem.friction && problem.friction->follows_temperature()) check_law(problem);
    if (!problem.temperature) return;
    validate(*problem.temperature, "temperature");
    if (problem.model == Model::hertz)
        throw InvalidArgument("model",
                              "is hertz, but temperature requires the slip of each element, which this model does not "
                              "compute: use full or fastsim");
    if (!problem.bodies.pair) check_elements(problem.bodies);
    if (!problem.friction && complete)
        throw InvalidArgument("temperature",
                              "requires rolling contact with friction: give friction, or remove temperature");
    if (!problem.friction) return;
    if (std::holds_alternative<Shift>(problem.motion))
        throw InvalidArgument(
            "temperature",
            "requires steady rolling, but friction has a shift: give friction.rolling, or remove temperature");
    check_rolling(std::get<Rolling>(problem.motion));
}

}  // namespace contactd
