#include "description.hpp"

#include <format>

namespace contactd::engine {

std::string description(const IcSpec& spec) {
    std::string text = spec.source == IcSource::fem ? "finite elements, " : "closed form, ";
    switch (spec.body) {
        case BodyShape::half_space:
            text += "a half-space";
            break;
        case BodyShape::block:
            text += "a block";
            break;
        case BodyShape::layered:
            text += "layers";
            break;
        case BodyShape::longitudinally_uniform:
            text += "a cross-section";
            break;
    }
    text += spec.any_nu ? std::string(" of every nu") : std::format(" of nu {:g}", spec.material.nu);
    text += std::format(": {} x {} {} of {:g} x {:g} mm", spec.nx, spec.ny, spec.section ? "elements" : "offsets",
                        spec.dx, spec.dy);
    if (spec.accuracy > 0) text += std::format(", accuracy {:g}", spec.accuracy);
    return text;
}

}  // namespace contactd::engine
