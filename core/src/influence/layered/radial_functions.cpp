#include "influence/layered/radial_functions.hpp"

#include "influence/layered/octave_integrals.hpp"

namespace contactd {

template <std::size_t count>
RadialFunctions<count>::RadialFunctions(const Layers& body, const std::array<RadialFunction, count>& functions,
                                        double least, double largest)
    : least_(least), octaves_(static_cast<std::size_t>(std::max(1.0, std::ceil(std::log2(largest / least))))) {
    OctaveIntegrals integrals(body, {functions.begin(), functions.end()}, largest);
    const auto& nodes = wavenumbers().chebyshev;
    for (std::size_t octave = octaves_.size(); octave-- > 0;) {
        const auto values = integrals.at_nodes(std::ldexp(least, static_cast<int>(octave)));
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            Values& coefficients = octaves_[octave][n];
            coefficients = {};
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                const double polynomial = std::cos(static_cast<double>(n) * std::acos(nodes[i]));
                const double factor = (n == 0 ? 1.0 : 2.0) / static_cast<double>(nodes.size());
                for (std::size_t f = 0; f < count; ++f) coefficients[f] += factor * polynomial * values[i][f];
            }
        }
    }
}

template class RadialFunctions<4>;
template class RadialFunctions<5>;

}  // namespace contactd
