// Defines the memory of friction that depends on slip velocity or temperature.
#pragma once

namespace contactd {

/// Describes friction with memory (Vollebregt and Schuttelaars, J. Sound Vib. 2012). The coefficient of a particle
/// follows the law over a distance d that it slips: d mu/dt = -max(v, v_0)/d (mu - mu(law)). A particle enters with the
/// static coefficient, or with that of surfaces that friction does not heat. The equation is integrated over a step by
/// the implicit Euler method.
struct FrictionMemory {
    double distance = 0;        ///< d > 0 (mm)
    double least_velocity = 0;  ///< v_0 >= 0 (mm/s)

    bool operator==(const FrictionMemory&) const = default;
};

}  // namespace contactd
