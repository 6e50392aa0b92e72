// The wavenumbers at which radial functions are integrated, and Bessel functions there.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace contactd {

/// For distances rho from p to 2p, all of it over p: nodes of rho, and of k p, with weights. It is the same for every
/// octave, so that Bessel functions are computed once.
struct Wavenumbers {
    static constexpr std::size_t radii = 24;
    static constexpr double least = 0x1p-9;  ///< of k p; below it powers of k rho are enough

    std::array<double, radii> chebyshev;  ///< points of [-1, 1]
    std::array<double, radii> rho;        ///< those of [1, 2]
    std::vector<double> k;                ///< from `least` on, in Gauss panels
    /// Weights of integrals over k, with a window that falls smoothly to zero where k rho is large. A compliance
    /// changes on the scale of k itself, so that what the window takes away is smaller than 1e-13.
    std::vector<double> weight;
    /// At k rho, [radius][wavenumber]: J_0 - 1, J_1, J_1 - k rho/2, without cancellation.
    std::array<std::vector<double>, radii> J0_less_1, J1, J1_less_half;
};

/// Made when it is first asked for.
const Wavenumbers& wavenumbers();

}  // namespace contactd
