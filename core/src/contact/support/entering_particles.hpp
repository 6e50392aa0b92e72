// Particles that enter the contact during a step of transient rolling.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "contactd/grid.hpp"

namespace contactd {

/// Holds a value for each element, and none where no particle enters: in steps no longer than an element, too.
struct EnteringParticles {
    /// For how much of the step its particle has been in contact: from the first element outside, upstream, on; at most
    /// 1, and 1 outside of the contact.
    std::vector<double> part;
    std::vector<std::size_t> from;  ///< that first element outside, or the last one of the grid

    bool empty() const { return part.empty(); }
};

/// `step` leads to where particles were before it (mm). `pressure` has shape [ny, nx].
EnteringParticles entering_particles(const Grid& grid, std::span<const double> pressure, std::array<double, 2> step);

}  // namespace contactd
