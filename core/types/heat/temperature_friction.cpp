#include "contactd/temperature_friction.hpp"

#include <algorithm>

#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd {

double friction_coefficient(const TemperatureFriction& law, double mu, double T) {
    return mu + law.change * std::clamp((T - law.reference) / law.range, 0.0, 1.0);
}

void validate(const TemperatureFriction& law, std::span<const double> mu) {
    constexpr double largest = 1e12;
    if (!(law.reference >= -largest && law.reference <= largest))
        throw InvalidArgument("friction.temperature.reference",
                              "is " + number_text(law.reference) + "; it must lie in [-1e12, 1e12] degrees Celsius");
    if (!(law.range > 0 && law.range <= largest))
        throw InvalidArgument("friction.temperature.range",
                              "is " + number_text(law.range) + "; it must lie in (0, 1e12] K");
    if (const auto& memory = law.memory) {
        if (!(memory->distance > 0 && memory->distance <= largest))
            throw InvalidArgument("friction.temperature.memory.distance",
                                  "is " + number_text(memory->distance) + "; it must lie in (0, 1e12] mm");
        if (!(memory->least_velocity >= 0 && memory->least_velocity <= largest))
            throw InvalidArgument("friction.temperature.memory.least_velocity",
                                  "is " + number_text(memory->least_velocity) + "; it must lie in [0, 1e12] mm/s");
    }
    for (const double cold : mu)
        if (!(cold + law.change > 0 && law.change <= 1000))
            throw InvalidArgument(
                "friction.temperature.change",
                "is " + number_text(law.change) + " with mu = " + number_text(cold) +
                    "; mu + change, the coefficient of hot surfaces, must be positive, and change at most 1000");
}

}  // namespace contactd
