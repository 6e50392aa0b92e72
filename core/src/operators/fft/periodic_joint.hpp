// Continues a kernel from its last offset to its next period.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace contactd {

/// Products do not use a kernel between the largest offsets of either sign, so it may be arbitrary there. Zeros, or its
/// mirror image next to it, cause a jump or a kink there, and transforms that decay slowly. Polynomials through the
/// last few values on both sides make it smooth.
class PeriodicJoint {
   public:
    /// Creates a joint that leaves zeros.
    PeriodicJoint() = default;
    /// Creates a joint for kernels at |offset| < offsets, offsets <= (period + 1)/2.
    PeriodicJoint(std::size_t offsets, std::size_t period);

    /// Fills an even or odd kernel; `values` has shape [period], with negative offsets at its end.
    void fill(std::span<double> values, bool even) const;
    /// Returns the least period with sufficient space for the joint.
    static std::size_t least_period(std::size_t offsets);

   private:
    std::size_t offsets_ = 0, nodes_ = 0;      // of either sign
    std::vector<double> positive_, negative_;  // [place from `offsets` on, to half the period][node], weights
};

}  // namespace contactd
