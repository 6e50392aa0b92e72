#include "contactd/temperature.hpp"

#include <cmath>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/temperature.hpp"
#include "types/number_text.hpp"

namespace contactd {

double ThermalBody::effusivity() const {
    constexpr double from_si = 1e-3;  // A joule is 1e3 N mm, and a square metre is 1e6 mm^2.
    return from_si * std::sqrt(conductivity * density * heat_capacity);
}

double ThermalBody::diffusivity() const {
    return 1e6 * conductivity / (density * heat_capacity);
}

bool rolls_along_x(double chi) {
    constexpr double rounding = 1e-9;
    return std::abs(std::sin(chi)) <= rounding;
}

void validate(const ThermalBodies& bodies, const std::string& field) {
    constexpr double least = 1e-15;  // The rise is proportional to the reciprocal.
    below(field, [&] { check_bounds(bodies); });
    if (const double both = bodies.upper.effusivity() + bodies.below().effusivity(); both < least)
        throw InvalidArgument(field + ".upper.conductivity",
                              "is " + number_text(bodies.upper.conductivity) + ", and that of the lower body is " +
                                  number_text(bodies.below().conductivity) +
                                  "; at least one of them must be positive to conduct the heat of friction");
}

}  // namespace contactd
