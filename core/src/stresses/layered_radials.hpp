// Defines the functions of the distance from a load from which stresses at a depth of a layered body are computed.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "influence/layered/stress_waves.hpp"

namespace contactd {

/// The functions are integrals over k from 0 to infinity of waves of StressWaves times a Bessel function, over 2 pi, in
/// this order:
struct StressRadial {
    enum Function : std::size_t {
        normal_zz,          // with J_1: their fields along e_rho have the wave as divergence
        normal_yy,          //
        normal_difference,  // xx - yy
        across_yz,          //
        shear_difference,   // xz of the plane minus yz across it
        normal_xz,          // with J_0: their gradients
        shear_zz,           //
        shear_xx,           //
        shear_yy,           //
        across_xy,          //
        third,              // with J_2: xx - yy - 2 xy across
        count
    };
    using Values = std::array<double, count>;
};

/// Interpolates the functions: up to the scale on which the waves decay, and from there octave by octave.
class StressRadials {
   public:
    /// Distances range from 0 to `largest`. Absolute errors are about 1e-12 over the larger of distance and scale.
    StressRadials(const StressWaves& waves, double largest);

    StressRadial::Values at(double rho) const;

   private:
    static constexpr std::size_t nodes = 24;
    using Interval = std::array<StressRadial::Values, nodes>;  // coefficients of Chebyshev's polynomials

    double first_;  // end of the first interval, where the octaves begin
    std::vector<Interval> intervals_;
};

}  // namespace contactd
