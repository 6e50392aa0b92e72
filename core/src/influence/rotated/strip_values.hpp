// Computes the nine coefficients between two strips, and rotates their axes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "contactd/section.hpp"
#include "influence/kernel_integrals.hpp"

namespace contactd {

/// Holds the displacement along i for a load along j at [3 i + j]; axes are x, s, n in the order of Axis.
using NineValues = std::array<double, 9>;

/// Returns the coefficients of the half-space from its kernels' integrals, times G.
NineValues nine_values(const KernelIntegrals& integrals, double nu);

/// Describes a strip relative to another one, with both on a half-space whose normal lies midway between theirs.
struct StripView {
    double s = 0;     ///< distance of the observed strip from the loaded one along the surface (mm)
    double turn = 0;  ///< angle of the observed strip's normal minus that of the loaded one's (rad)
};

/// Returns the view of one strip from another. Strips of arc length ds are adjacent. On a closed curve of the length
/// `perimeter` the shorter way counts; 0 means that there is only one way.
StripView view_of(std::span<const StripFrame> frames, double ds, double perimeter, int observed, int loaded);

/// Rotates from the axes midway between two strips to those of both.
class StripAxes {
   public:
    explicit StripAxes(double turn) : sine_(std::sin(turn / 2)), cosine_(std::cos(turn / 2)) {}

    /// Returns displacements along axes rotated by turn/2, for loads along axes rotated by -turn/2.
    NineValues operator()(NineValues midway) const {
        for (std::size_t j = 0; j < 3; ++j) turn_axes(midway[3 + j], midway[6 + j], sine_);
        for (std::size_t i = 0; i < 3; ++i) turn_axes(midway[3 * i + 1], midway[3 * i + 2], -sine_);
        return midway;
    }

   private:
    // Rotates components along s and n to axes whose normal leans towards +s by the angle with this sine.
    void turn_axes(double& s, double& n, double sine) const {
        const double along_s = cosine_ * s - sine * n;
        n = sine * s + cosine_ * n;
        s = along_s;
    }

    double sine_, cosine_;
};

}  // namespace contactd
