#include "contactd/material.hpp"

#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "magnitude.hpp"
#include "number_text.hpp"

namespace contactd {

bool MaterialPair::quasi_identical() const {
    const double a = (1 - 2 * upper.nu) / upper.G;  // zero for a rigid body
    const double b = (1 - 2 * lower.nu) / lower.G;
    return std::abs(a - b) <= 1e-12 * (1 / upper.G + 1 / lower.G);
}

double MaterialPair::normal_compliance() const {
    return (1 - upper.nu) / (2 * upper.G) + (1 - lower.nu) / (2 * lower.G);
}

void validate(const Material& material, const char* field, bool incompressible_allowed) {
    const std::string name = field;
    if (!std::isfinite(material.G) || material.G <= 0)
        throw InvalidArgument(name + ".G", "is " + number_text(material.G) + "; it must be a positive, finite number");
    check_magnitude(material.G, name + ".G");
    if (!(material.nu >= 0 && material.nu <= 0.5))
        throw InvalidArgument(name + ".nu", "is " + number_text(material.nu) + "; it must lie in [0, 0.5]");
    if (material.nu == 0.5 && !incompressible_allowed)
        throw InvalidArgument(name + ".nu",
                              "is 0.5; finite elements require nu < 0.5, and only closed-form coefficients allow 0.5");
}

}  // namespace contactd
