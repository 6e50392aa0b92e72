// Defines the stored influence coefficients of a longitudinally uniform body: their transform along x at a few
// wavenumbers. Tables for any length and number of elements along x are computed from it.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/observer.hpp"
#include "contactd/section.hpp"
#include "contactd/strip_table.hpp"

namespace contactd {

/// Holds the displacement along i at the middle of strip I for a unit traction along j over strip J that varies as
/// cos(xi x), or as sin(xi x) if j is x. Values are amplitudes of cos for y and z, and of sin for x, which make a
/// symmetric matrix of a = 3 I + i and b = 3 J + j. They are for G = 1, with all lengths over the width ds of a strip.
struct StripSpectrum {
    int strips = 0;
    double nu = 0;
    double xi0 = 0;                    ///< nodes are even in asinh(xi/xi0), and xi0 screens the reference
    std::vector<double> nodes;         ///< wavenumbers, ascending from 0; 1/ds
    std::vector<double> values;        ///< shape [nodes, 3 strips (3 strips + 1)/2]: a >= b; ds/G
    std::vector<StripFrame> frames{};  ///< of the strips

    std::size_t component_size() const {
        const std::size_t n = 3 * static_cast<std::size_t>(strips);
        return n * (n + 1) / 2;
    }
    /// Returns the index of the entry (a, b) at a node, in either order.
    std::size_t index(std::size_t node, int a, int b) const {
        const auto high = static_cast<std::size_t>(a > b ? a : b), low = static_cast<std::size_t>(a > b ? b : a);
        return node * component_size() + high * (high + 1) / 2 + low;
    }

    bool operator==(const StripSpectrum&) const = default;
};

/// Returns the coefficients at the offsets k dx + shift along x, k = 0..nx-1 (dx and shift over ds), times `factor`:
/// ds/G for mm^3/N. With a shift there is no parity; the offsets -k dx + shift are those of -shift, with the parity of
/// each component. Between the wavenumbers, the difference to the half-space is interpolated (cubic, with its parity),
/// with load and displacement each rotated by half the angle between the strips; the half-space itself is exact.
/// `threads` includes the calling thread and does not affect the coefficients. Throws NotFinite if a coefficient is
/// beyond a double's range, and Cancelled; all threads call the observer.
StripTable strip_table(const StripSpectrum& spectrum, double dx, int nx, double shift = 0, double factor = 1,
                       int threads = 1, const Observer& observer = {});

}  // namespace contactd
