// Defines the wavenumbers at which radial functions are integrated, and Bessel functions there.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace contactd {

/// Holds nodes of rho, and of k p with weights, for distances rho from p to 2p, all of it over p. It is the same for
/// every octave, so that Bessel functions are computed once.
struct Wavenumbers {
    static constexpr std::size_t radii = 24;
    static constexpr double least = 0x1p-9;  ///< smallest k p; below it powers of k rho are sufficient

    std::array<double, radii> chebyshev;  ///< points of [-1, 1]
    std::array<double, radii> rho;        ///< points of [1, 2]
    std::vector<double> k;                ///< from `least` on, in Gauss panels
    /// Holds weights of integrals over k, with a window that decreases smoothly to zero where k rho is large. A
    /// compliance changes on the scale of k itself, so that the window removes less than 1e-13.
    std::vector<double> weight;
    /// Hold J_0 - 1, J_1 and J_1 - k rho/2 at k rho, [radius][wavenumber], without cancellation.
    std::array<std::vector<double>, radii> J0_less_1, J1, J1_less_half;
};

/// Returns the wavenumbers, which are computed on first use.
const Wavenumbers& wavenumbers();

}  // namespace contactd
