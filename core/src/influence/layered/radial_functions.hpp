// Interpolates the radial functions along edges, all at once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "influence/layered/radial_function.hpp"
#include "influence/layered/wavenumbers.hpp"

namespace contactd {

/// Holds `count` radial functions at distances from `least` to `largest`, by interpolation in each octave.
template <std::size_t count>
class RadialFunctions {
   public:
    using Values = std::array<double, count>;

    RadialFunctions(const Layers& body, const std::array<RadialFunction, count>& functions, double least,
                    double largest);

    /// Returns the values at a distance; below `least`, those at `least`. The absolute error is at most 1e-12 of the
    /// significant values at that distance.
    Values at(double rho) const {
        int octave = rho > least_ ? std::ilogb(rho / least_) : 0;
        octave = std::min(octave, static_cast<int>(octaves_.size()) - 1);
        const double x = std::max(2 * std::ldexp(rho / least_, -octave) - 3, -1.0);
        const auto& coefficients = octaves_[static_cast<std::size_t>(octave)];
        Values b1{}, b2{};  // for Clenshaw's recurrence
        for (std::size_t n = coefficients.size() - 1; n > 0; --n)
            for (std::size_t f = 0; f < count; ++f) {
                const double b0 = coefficients[n][f] + 2 * x * b1[f] - b2[f];
                b2[f] = b1[f];
                b1[f] = b0;
            }
        Values result;
        for (std::size_t f = 0; f < count; ++f) result[f] = coefficients[0][f] + x * b1[f] - b2[f];
        return result;
    }

   private:
    using Octave = std::array<Values, Wavenumbers::radii>;  // coefficients of Chebyshev's polynomials

    double least_;
    std::vector<Octave> octaves_;
};

extern template class RadialFunctions<4>;
extern template class RadialFunctions<5>;

}  // namespace contactd
