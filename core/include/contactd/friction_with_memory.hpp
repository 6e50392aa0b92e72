// Memory of friction that depends on slip velocity or temperature.
#pragma once

namespace contactd {

/// Friction with memory (Vollebregt and Schuttelaars, J. Sound Vib. 2012): the coefficient of a particle follows the
/// law over a distance d that it slips, d mu/dt = -max(v, v_0)/d (mu - mu(law)), from the one with which it enters: the
/// static one, or that of surfaces that no friction heats. By implicit Euler over a step.
struct FrictionMemory {
    double distance = 0;        ///< d > 0 (mm)
    double least_velocity = 0;  ///< v_0 >= 0 (mm/s)

    bool operator==(const FrictionMemory&) const = default;
};

}  // namespace contactd
