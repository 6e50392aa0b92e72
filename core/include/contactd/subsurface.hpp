// Stresses inside a half-space under the tractions of a contact (Love 1929; Johnson, Contact Mechanics, sections 3.1
// and 3.2; Kalker 1990, section 5.A). Tractions are constant on each element; those of bilinear coefficients are taken
// as if they were, from the values at the element centres.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "contactd/grid.hpp"
#include "contactd/observer.hpp"

namespace contactd {

enum class ContactBody { upper, lower };

/// Each body has a frame of its own, in which it is z <= 0 and its outward normal is +z: x and y are those of the grid,
/// -z is the distance from the surface into the body. The frame of the lower body is that of the contact problem, that
/// of the upper one its mirror image: turned into the frame of the problem, xz and yz of the upper body change sign.
///
/// Tractions that act on the surface of a body, in its frame, each of shape [ny, nx] (N/mm^2); empty means zero.
struct SurfaceTractions {
    std::vector<double> x, y, z;
};

/// From the results of a contact problem: pressure (> 0 in compression) and the tractions on the upper body.
SurfaceTractions tractions_on(ContactBody body, std::span<const double> pressure, std::span<const double> traction_x,
                              std::span<const double> traction_y);

/// At the points asked for, in their order (N/mm^2); tension is positive.
struct SubsurfaceStress {
    std::vector<double> xx, yy, zz, xy, xz, yz;
    std::vector<double> von_mises;
    std::size_t largest = 0;  ///< the point with the largest von Mises stress; the first one of equals
};

/// The points (x[ix], y[iy], z[iz]) in any order, with index (iz*ny + iy)*nx + ix: results have shape [nz, ny, nx].
struct StressBlock {
    std::vector<double> x, y, z;  ///< (mm), z <= 0

    std::size_t size() const { return x.size() * y.size() * z.size(); }
};

/// `nu` is the body's Poisson's ratio; its shear modulus does not matter. Absolute accuracy 1e-11 of the largest
/// traction. On the surface the values are the limits from below: at an edge of an element, where tractions jump, their
/// mean; and where they are infinite as a logarithm (beside a jump of the tangential traction, at corners), those at a
/// distance of a millionth of the element. Nearer to the surface than an element, the steps of the tractions show.
/// Reports the stage "subsurface". Throws InvalidArgument ("tractions.x", "nu", "points", "block.z", ...) and
/// Cancelled.
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, double nu,
                                   std::span<const std::array<double, 3>> points, Observer& observer);

/// The same on a block. Coordinates that differ by whole elements share convolutions, one for every depth and stress;
/// the more of them there are, the less a point costs. Memory is some multiple of that of the points and elements.
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, double nu,
                                   const StressBlock& block, Observer& observer);

}  // namespace contactd
