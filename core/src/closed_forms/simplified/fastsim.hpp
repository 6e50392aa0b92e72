// Solves rolling contact by FASTSIM (Kalker 1982; Kalker 1990, section 3.7), the simplified theory, in microseconds.
#pragma once

#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/forces_by_motion.hpp"

namespace contactd {

/// Holds displacement over traction, u = L p, for longitudinal and lateral creepage and for spin (mm^3/N), such that
/// the forces of small creepages are those of Kalker's coefficients. With a along the rolling direction L1 = 8a/(3 C11
/// G), L2 = 8a/(3 C22 G), L3 = pi a sqrt(a/b)/(4 C23 G). Throws InvalidArgument ("gap") for a/b outside 1/32 to 32.
struct Flexibilities {
    double L1, L2, L3;
};
Flexibilities flexibilities(const SemiAxes& axes, const Material& combined);

/// Sets the steps along each slice of the contact area, and the number of slices. The error of finite steps is that of
/// the slip's direction under spin, at most about 0.5/steps of mu Fn; slices add little to it.
struct FastsimSettings {
    int steps = 48;
    int slices = 12;

    bool operator==(const FastsimSettings&) const = default;
};

/// Solves steady rolling.
///
/// In adhesion, dp/dx = (xi/L1 - phi y/L3, eta/L2 + phi x/L3), from p = 0 at the leading edge backwards. In slip, |p| =
/// g = mu 2 Fn/(pi ab) (1 - x^2/a^2 - y^2/b^2), opposite to the slip, whose components are L1 and L2 times the
/// difference of dp/dx from its value in adhesion. g is the simplified theory's bound, a paraboloid with the force mu
/// Fn; it exceeds mu times Hertz's pressure in the middle. Full slip gives mu Fn exactly, against the creepage, and
/// vanishing creepages give Kalker's forces exactly. Otherwise forces are within some 9 per cent of mu Fn of the exact
/// theory's, and Mz within some 11 per cent of mu Fn sqrt(ab).
///
/// `rolling` prescribes xi and eta, or Fx and Fy, or one of each. For prescribed forces the creepage is searched, and
/// `force` describes how that search ended. `steady`, `steps` and `dq` are not used. Throws InvalidArgument
/// ("friction.rolling.chi") for a direction that is not an axis of the ellipse (unless it is a circle), ("gap") for a/b
/// outside 1/32 to 32, ("friction.rolling.force") for a force that friction cannot carry, and ("fastsim.steps",
/// "fastsim.slices") outside 8 to 10000.
EllipticFriction fastsim(const Grid& grid, const EllipticContact& contact, double mu, const Rolling& rolling,
                         const FastsimSettings& settings = {});

/// Differentiates the forces at known creepages exactly, including spin. `contact` is not empty, mu > 0, and `rolling`
/// has been solved by fastsim.
ForcesByMotion fastsim_by_motion(const EllipticContact& contact, double mu, const Rolling& rolling,
                                 const FastsimSettings& settings = {});

}  // namespace contactd
