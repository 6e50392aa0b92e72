// Defines the functions of the distance from a load that make up the displacements of a layered body.
#pragma once

#include "influence/layered/wave_compliance.hpp"

namespace contactd {

/// Represents the integral over k from 0 to infinity of C(k)/k^power B(k rho), over 2 pi G; C is a component of a
/// WaveCompliance.
struct RadialFunction {
    enum class Kernel {
        J1,              ///< J_1
        J0_regularised,  ///< J_0 - r(k), with r(0) = 1 and the same r for all distances
        J1_regularised,  ///< J_1 - k rho/2 r(k)
    };
    double (*component)(const WaveCompliance& compliance);
    int power;
    Kernel kernel;
};

}  // namespace contactd
