#include "contactd/layers.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

void check_thickness(double thickness, double dx, const std::string& field) {
    if (!(std::isfinite(thickness) && thickness > 0))
        throw InvalidArgument(field, "is " + number_text(thickness) + "; it must be a positive, finite length (mm)");
    const double ratio = thickness / dx;
    if (!(ratio >= thinnest_layer && ratio <= thickest_layer))
        throw InvalidArgument(field, "is " + number_text(thickness) + ", " + short_text(ratio) +
                                         " times dx; it must lie between 1e-6 and 1e6 times dx: omit a thinner layer, "
                                         "and use a half-space for a thicker one");
}

}  // namespace

void validate(const Layers& body, double dx, const char* field) {
    const std::string name = field, list = name + ".layers";
    if (body.layers.empty()) throw InvalidArgument(list, "is empty; give at least one layer, or use body half_space");
    if (body.layers.size() > most_layers)
        throw InvalidArgument(list, "has " + std::to_string(body.layers.size()) + " layers, but at most " +
                                        std::to_string(most_layers) + " are supported: merge similar ones");
    double softest = body.layers.front().G, stiffest = softest;
    const auto add = [&](const Material& material, const std::string& of) {
        validate(material, of.c_str(), true);
        softest = std::min(softest, material.G);
        stiffest = std::max(stiffest, material.G);
        if (stiffest > largest_layer_contrast * softest)
            throw InvalidArgument(
                of + ".G", "is " + number_text(material.G) + ", but shear moduli range from " + number_text(softest) +
                               " to " + number_text(stiffest) +
                               "; their ratio must not exceed 1e9: use a rigid base for a very stiff one");
    };
    for (std::size_t i = 0; i < body.layers.size(); ++i) {
        const std::string of = list + "[" + std::to_string(i) + "]";
        check_thickness(body.layers[i].thickness, dx, of + ".thickness");
        add(body.layers[i].material(), of);
    }
    if (!body.base.is_rigid()) add(body.base, name + ".base");
}

}  // namespace contactd
