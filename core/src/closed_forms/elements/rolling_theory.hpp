// Defines the common part of FASTSIM on elements, FaStrip and Polach's theory, in the frame of rolling.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "closed_forms/dual.hpp"
#include "closed_forms/kalker_coefficients.hpp"
#include "closed_forms/simplified/fastsim_slice.hpp"
#include "contactd/contact_setup.hpp"

namespace contactd {

/// Describes a contact in the frame of rolling: a is along the rolling direction.
struct RollingTheory {
    SemiAxes axes, counted;
    KalkerCoefficients C{};
    double G = 0, nu = 0, Fn = 0;
    double static_mu = 0;
    double spin_ahead = 0;  ///< distance ahead of centres at which spin is evaluated (mm)
    /// Blends flexibilities if forces are prescribed. It is the motion as given, so that they do not change during the
    /// search for the motion. If absent, the motion itself blends them.
    std::optional<FastsimCreepages<double>> given{};
    SimplifiedSettings settings;
};

/// Holds displacement over traction for creepages along and across, and for spin (mm^3/N).
template <class Number>
struct FlexibilitiesOf {
    Number L1, L2, L3;
};

/// Returns the lateral creepage with the share of spin if that increases it: e = eta + phi a, or eta if that is larger.
template <class Number>
Number lateral_with_spin(const FastsimCreepages<Number>& w, double a) {
    using std::abs;
    const Number with = w.eta + a * w.phi;
    return abs(with) > abs(w.eta) ? with : w.eta;
}

/// Returns the factor k of SlopeReduction.
template <class Number>
Number slope_factor(const RollingTheory& theory, const FastsimCreepages<Number>& w, double mu) {
    using std::sqrt;
    const SlopeReduction& slope = theory.settings.slope;
    if (slope.alpha == 1 || !(mu > 0)) return Number(slope.k0);
    const auto [a, b] = theory.counted;
    const Number e = lateral_with_spin(w, a);
    const double unit = theory.G * std::numbers::pi * a * b * slope.k0 * theory.C.C11 / (4 * mu * theory.Fn);
    const Number eps = unit * sqrt(w.xi * w.xi + e * e);
    return slope.k0 * (slope.alpha + Number(1 - slope.alpha) / (1 + slope.beta * eps));
}

/// Returns the flexibilities of FASTSIM with all settings applied. Blended ones become equal where creepages are three
/// times those of full slip, xi = mu Fn/(a b G C11) and eta likewise. They become the mean of the three, weighted by
/// the squares of xi, eta and 3 pi a phi/32.
template <class Number>
FlexibilitiesOf<Number> flexibilities_of(const RollingTheory& theory, const FastsimCreepages<Number>& w, double mu) {
    using std::sqrt;
    const auto [a, b] = theory.axes;
    const double unit = a / theory.G;
    FlexibilitiesOf<Number> L{8 * unit / (3 * theory.C.C11), 8 * unit / (3 * theory.C.C22),
                              std::numbers::pi * unit * std::sqrt(a / b) / (4 * theory.C.C23)};
    const auto& at = theory.given;
    const Number xi = at ? Number(at->xi) : w.xi, eta = at ? Number(at->eta) : w.eta;
    const Number spin = 3 * std::numbers::pi * a / 32 * w.phi, creepage = xi * xi + eta * eta;
    const Number size = creepage + spin * spin;
    if (theory.settings.blended && size > Number(0) && theory.static_mu > 0) {
        const Number one = size / (xi * xi / L.L1 + eta * eta / L.L2 + spin * spin / L.L3);
        const double full = theory.static_mu * theory.Fn / (a * b * theory.G);
        const double full_size = full * std::hypot(1 / theory.C.C11, 1 / theory.C.C22);
        Number share = sqrt(creepage) / (3 * full_size);
        if (share > Number(1)) share = Number(1);
        L = {(1 - share) * L.L1 + share * one, (1 - share) * L.L2 + share * one, (1 - share) * L.L3 + share * one};
    }
    const Number k = slope_factor(theory, w, mu);
    return {L.L1 / k, L.L2 / k, L.L3 / k};
}

}  // namespace contactd
