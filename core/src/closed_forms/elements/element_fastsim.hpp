// Computes FASTSIM (Kalker 1982) in whole steps of elements, on a contact of any shape.
#pragma once

#include <span>

#include "element_tractions.hpp"
#include "rolling_theory.hpp"

namespace contactd {

/// Returns the tractions p = p_before - dx (xi/L1 - phi y/L3, eta/L2 + phi x/L3) from element to element, from zero
/// ahead of the first one, scaled to the bound g where they exceed it. x is that of the centre plus spin_ahead. `bound`
/// is g over mu, shape [ny, nx] (N/mm^2).
template <class Number>
ElementTractions<Number> fastsim_on_elements(const ElementLines& lines, std::span<const double> bound,
                                             const RollingTheory& theory, const FastsimCreepages<Number>& w,
                                             double mu) {
    using std::sqrt;
    ElementTractions<Number> t(bound.size());
    const FlexibilitiesOf<Number> L = flexibilities_of(theory, w, mu);
    const double dx = lines.step();
    const Number none{}, spin = w.phi / L.L3, along = w.xi / L.L1, across = w.eta / L.L2;
    for (int line = 0; line < lines.count(); ++line) {
        Number px{}, py{};
        const Number slope_x = along - lines.across(line) * spin;
        for (int place = 0; place < lines.length(); ++place) {
            const std::size_t i = lines.element(line, place);
            if (!(bound[i] > 0)) {
                px = py = none;
                continue;
            }
            const Number trial_x = px - dx * slope_x;
            const Number trial_y = py - dx * (across + (lines.along(place) + theory.spin_ahead) * spin);
            const Number size = sqrt(trial_x * trial_x + trial_y * trial_y);
            const double g = mu * bound[i];
            t.division[i] = ElementState::adhesion;
            px = trial_x;
            py = trial_y;
            if (!(size > Number(g)) && mu > 0) {
                t.px[i] = px;
                t.py[i] = py;
                continue;
            }
            const Number share = size > none ? g / size : none;
            px = share * trial_x;
            py = share * trial_y;
            t.division[i] = ElementState::slip;
            t.px[i] = px;
            t.py[i] = py;
            t.slip_x[i] = L.L1 / dx * (px - trial_x);
            t.slip_y[i] = L.L2 / dx * (py - trial_y);
        }
    }
    return t;
}

}  // namespace contactd
