#include "contactd/friction.hpp"

#include <algorithm>
#include <cmath>

#include "contactd/error.hpp"
#include "number_text.hpp"

namespace contactd {

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
}

double friction_coefficient(const KineticFriction& kinetic, double mu_static, double v) {
    const double fall = mu_static - kinetic.mu, relative = v / kinetic.slip_velocity;
    switch (kinetic.law) {
        case SlipLaw::linear:
            return std::max(kinetic.mu, mu_static - fall * relative);
        case SlipLaw::exponential:
            break;
    }
    return kinetic.mu + fall * std::exp(-relative);
}

}  // namespace contactd
