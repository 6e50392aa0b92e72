#include "contactd/friction.hpp"

#include <algorithm>
#include <cmath>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/friction.hpp"
#include "number_text.hpp"

namespace contactd {
namespace {

// Returns the remaining fraction of a term.
double share(SlipLaw law, double relative) {
    switch (law) {
        case SlipLaw::linear:
            return std::max(0.0, 1 - relative);
        case SlipLaw::exponential:
            return std::exp(-relative);
        case SlipLaw::rational:
            break;
    }
    return 1 / (1 + relative);
}

}  // namespace

void validate(const KineticFriction& kinetic, std::span<const double> mu_static) {
    if (!(kinetic.slip_velocity > 0) || !std::isfinite(kinetic.slip_velocity))
        throw InvalidArgument("friction.kinetic.slip_velocity",
                              "is " + number_text(kinetic.slip_velocity) + "; it must be positive and finite");
    if (!(kinetic.mu >= 0))
        throw InvalidArgument("friction.kinetic.mu", "is " + number_text(kinetic.mu) + "; it must not be negative");
    for (const double mu : mu_static)
        if (!(kinetic.mu <= mu))
            throw InvalidArgument("friction.kinetic.mu", "is " + number_text(kinetic.mu) +
                                                             "; it must not exceed the static coefficient, which is " +
                                                             number_text(mu));
    const auto check = [](bool holds, const char* field, double value, const char* range) {
        if (!holds || !std::isfinite(value))
            throw InvalidArgument("friction.kinetic." + std::string(field),
                                  "is " + number_text(value) + "; it must be " + range + " and finite");
    };
    if (const auto& second = kinetic.second) {
        check(second->slip_velocity > 0, "second.slip_velocity", second->slip_velocity, "positive");
        check(second->fall >= 0, "second.fall", second->fall, "zero or positive");
        for (const double mu : mu_static)
            if (constexpr double rounding = 1e-12; !(second->fall <= mu - kinetic.mu + rounding))
                throw InvalidArgument(
                    "friction.kinetic.second.fall",
                    "is " + number_text(second->fall) +
                        "; it must not exceed the fall from the static coefficient to the kinetic one, " +
                        number_text(mu - kinetic.mu));
    }
    if (const auto& memory = kinetic.memory) {
        check(memory->distance > 0, "memory.distance", memory->distance, "positive");
        check(memory->least_velocity >= 0, "memory.least_velocity", memory->least_velocity, "zero or positive");
    }
}

void validate(const InterfacialLayer& layer) {
    below("friction.layer", [&] { check_bounds(layer); });
    if (layer.hardening == 0) return;
    const char* const field = "friction.layer.hardening";
    if (!layer.yields())
        throw InvalidArgument(field, "is " + number_text(layer.hardening) +
                                         ", but the layer has no yield_stress: give it, or remove hardening");
    if (layer.flexibility > 0 && !(layer.hardening * layer.flexibility > -1))
        throw InvalidArgument(
            field, "is " + number_text(layer.hardening) + "; it must be above " + number_text(-1 / layer.flexibility) +
                       ", which is -1/flexibility: a layer that softens faster than it unloads is unstable");
}

double friction_coefficient(const KineticFriction& kinetic, double mu_static, double v) {
    if (kinetic.second) {
        const double fall = std::min(kinetic.second->fall, mu_static - kinetic.mu);
        const double relative = v / kinetic.second->slip_velocity;
        KineticFriction first = kinetic;
        first.second.reset();
        const double left = friction_coefficient(first, mu_static - fall, v);
        return left +
               fall * (kinetic.law == SlipLaw::rational ? 1 / (1 + relative * relative) : share(kinetic.law, relative));
    }
    const double fall = mu_static - kinetic.mu, relative = v / kinetic.slip_velocity;
    switch (kinetic.law) {
        case SlipLaw::linear:
            return std::max(kinetic.mu, mu_static - fall * relative);
        case SlipLaw::exponential:
        case SlipLaw::rational:
            break;
    }
    return kinetic.mu + fall * share(kinetic.law, relative);
}

}  // namespace contactd
