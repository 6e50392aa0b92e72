// How a kernel that is given up to some offset goes on to its next period.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace contactd {

/// Between the largest offsets of either sign, where no product reads it, a kernel may be what it likes. Zeros, or its
/// own mirror image next to it, make a jump or a kink there, and transforms that fall slowly. Polynomials through the
/// last few values on both sides make a smooth function of it.
class PeriodicJoint {
   public:
    /// Leaves zeros.
    PeriodicJoint() = default;
    /// Takes kernels at |offset| < offsets, offsets <= (period + 1)/2.
    PeriodicJoint(std::size_t offsets, std::size_t period);

    /// `values` of shape [period], those of negative offsets at its end; even, or odd.
    void fill(std::span<double> values, bool even) const;
    /// Returns the least period that leaves room for it.
    static std::size_t least_period(std::size_t offsets);

   private:
    std::size_t offsets_ = 0, nodes_ = 0;      // of either sign
    std::vector<double> positive_, negative_;  // [place from `offsets` on, to half the period][node], weights
};

}  // namespace contactd
