// Closed-form solutions to compare with: Hertz (Johnson, Contact Mechanics, section 4.2) and Cattaneo (section 7.2).
#pragma once

#include "contactd/material.hpp"

namespace contactd::reference {

/// Sphere on plane (or two spheres of combined radius R), approach prescribed.
struct Hertz {
    double radius;  ///< of the contact circle, sqrt(R delta) (mm)
    double Fn;      ///< (N)
    double pmax;    ///< (N/mm^2)
};
Hertz hertz(const BodyPair& bodies, double R, double approach);

/// Hertz contact shifted by Fx < mu Fn without lateral effects.
struct Cattaneo {
    double adhesion_radius;  ///< (mm)
    double rigid_shift;      ///< (mm), positive, that goes with Fx
};
Cattaneo cattaneo(const BodyPair& bodies, const Hertz& hertz, double mu, double Fx);

}  // namespace contactd::reference
