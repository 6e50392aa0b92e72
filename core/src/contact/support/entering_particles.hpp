// Describes particles that enter the contact during a step of transient rolling.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "contactd/grid.hpp"

namespace contactd {

/// Holds a value for each element. It is empty if no particle enters, or if the step is not longer than an element.
struct EnteringParticles {
    /// Holds the fraction of the step for which the particle has been in contact, from the first element outside,
    /// upstream; it is at most 1, and 1 outside the contact.
    std::vector<double> part;
    std::vector<std::size_t> from;  ///< first element outside, upstream, or the last one of the grid

    bool empty() const { return part.empty(); }
};

/// Returns the particles. `step` points to the previous positions of particles (mm). `pressure` has shape [ny, nx].
EnteringParticles entering_particles(const Grid& grid, std::span<const double> pressure, std::array<double, 2> step);

}  // namespace contactd
