#include "creep_curves.hpp"

#include <cmath>

#include "closed_forms/kalker_coefficients.hpp"
#include "creep_table/spline_fit.hpp"

namespace contactd::creep_table {

std::vector<double> creep_curves(const SplineAxis& axis, double nu) {
    const int nodes = axis.cells + 1;
    std::vector<double> values(static_cast<std::size_t>(curve_count * nodes));
    for (int node = 0; node <= axis.cells; ++node) {
        const double ratio = std::exp(axis.node(node));
        const auto [xi, eta, phi] = full_slip(ratio, nu);
        const KalkerCoefficients C = kalker_coefficients(ratio, nu);
        const double at_node[curve_count] = {1 / xi, 1 / eta, 1 / phi, C.C11, C.C22, C.C23, C.C33};
        for (int curve = 0; curve < curve_count; ++curve)
            values[static_cast<std::size_t>(curve * nodes + node)] = at_node[curve];
    }
    return multiply_along(spline_fit(axis.cells, SplineEnd::not_a_knot, SplineEnd::not_a_knot),
                          with_zero_ends(values, nodes, 1), 1);
}

}  // namespace contactd::creep_table
