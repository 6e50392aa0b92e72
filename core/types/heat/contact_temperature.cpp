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
        throw InvalidArgument("friction.rolling.kind",
                              "is transient, and temperature is given; temperatures are those of steady rolling, which "
                              "has gone on for long");
    if (!rolls_along_x(rolling.chi))
        throw InvalidArgument("friction.rolling.chi",
                              "is " + number_text(rolling.chi) +
                                  ", and temperature is given; temperatures are those of rolling along x, 0 or pi, "
                                  "in which heat stays in its row of elements");
    if (rolling.velocity == Rolling{}.velocity)
        throw InvalidArgument("friction.rolling.velocity",
                              "is 1 mm/s, as where it is left out, and temperature is given; heat is that of the "
                              "velocity, and temperatures are those of fast rolling");
}

void check_elements(const Bodies& bodies) {
    for (const auto& [body, name] : {std::pair{&bodies.upper, "upper"}, std::pair{&bodies.lower, "lower"}})
        if (const Ics* ics = body->computed(); ics != nullptr && ics->load_shape == LoadShape::bilinear)
            throw InvalidArgument(std::string("bodies.") + name + ".ics.load_shape",
                                  "is bilinear, and temperature is given; temperatures are those of elements with "
                                  "constant tractions");
}

/// Each with the coefficients of its row.
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
        throw InvalidArgument("friction.temperature",
                              "is given, and temperature is not; say there what the bodies have to do with heat");
    if (friction.temperature) validate(*friction.temperature, friction.mu);
    if (!friction.temperature_of_rows.empty()) check_rows(problem);
    if (problem.model != Model::full)
        throw InvalidArgument("friction.temperature",
                              "makes friction depend on the temperature, which simplified models do not know; model "
                              "full does");
    if (friction.kinetic)
        throw InvalidArgument("friction.temperature",
                              "is given, and friction.kinetic, too; friction follows the temperature or the slip "
                              "velocity: leave one of them out");
    if (problem.derivatives)
        throw InvalidArgument("derivatives",
                              "are not known where friction follows the temperature; leave friction.temperature out, "
                              "or take differences of solves");
}

}  // namespace

void check_temperature(const ContactProblem& problem, bool complete) {
    if (problem.friction && problem.friction->follows_temperature()) check_law(problem);
    if (!problem.temperature) return;
    validate(*problem.temperature, "temperature");
    if (problem.model == Model::hertz)
        throw InvalidArgument("model",
                              "is hertz, and temperature is given; heat is that of the slip of each element, which "
                              "this model does not tell: take full or fastsim");
    if (!problem.bodies.pair) check_elements(problem.bodies);
    if (!problem.friction && complete)
        throw InvalidArgument("temperature",
                              "is given, and friction is not; temperatures are those of rolling contact");
    if (!problem.friction) return;
    if (std::holds_alternative<Shift>(problem.motion))
        throw InvalidArgument("temperature",
                              "is given, and friction has a shift; temperatures are those of steady rolling: give "
                              "friction.rolling, or leave temperature out");
    check_rolling(std::get<Rolling>(problem.motion));
}

}  // namespace contactd
