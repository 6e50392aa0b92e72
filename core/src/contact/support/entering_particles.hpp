// Particles that enter the contact during a step of transient rolling.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "contactd/grid.hpp"

namespace contactd {

/// Of each element. Empty where no particle enters that is told from the others: in steps no longer than an element.
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
