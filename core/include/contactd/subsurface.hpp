// Stresses inside a half-space, or a body of layers, under the tractions of a contact (Love 1929; Johnson, Contact
// Mechanics, sections 3.1 and 3.2; Kalker 1990, section 5.A). Tractions are constant on each element; those of bilinear
// coefficients are taken as if they were, from the values at the element centres.
#pragma once

#include <array>
#include <span>

#include "contactd/grid.hpp"
#include "contactd/layers.hpp"
#include "contactd/material.hpp"
#include "contactd/observer.hpp"
#include "contactd/subsurface_stress.hpp"

namespace contactd {

/// From the results of a contact problem: pressure (> 0 in compression) and the tractions on the upper body.
SurfaceTractions tractions_on(ContactBody body, std::span<const double> pressure, std::span<const double> traction_x,
                              std::span<const double> traction_y);

/// `nu` is the body's Poisson's ratio; its shear modulus does not matter. Absolute accuracy 1e-11 of the largest
/// traction. On the surface the values are the limits from below: at an edge of an element, where tractions jump, their
/// mean; and where they are infinite as a logarithm (beside a jump of the tangential traction, at corners), those at a
/// distance of a millionth of the element. Nearer to the surface than an element, the steps of the tractions show.
/// Reports the stage "subsurface". Throws InvalidArgument ("tractions.x", "nu", "points", "block.z", ...) and
/// Cancelled.
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, double nu,
                                   std::span<const std::array<double, 3>> points, Observer& observer);

/// Returns the stresses on a block. Coordinates that differ by whole elements share convolutions, one for every depth
/// and stress; the more of them there are, the less a point costs. Memory is some multiple of that of the points and
/// elements.
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, double nu,
                                   const StressBlock& block, Observer& observer);

/// A half-space under a line contact: tractions neither change nor end along y, and nothing stretches along it.
struct PlaneStrain {
    double nu = 0;  ///< Poisson's ratio; it decides yy alone
};

/// Inside it, by line forces integrated over the elements (Johnson, sections 2.2 and 2.3); tractions along y make
/// anti-plane shear. The grid has one row; dy and the points' y mean nothing. Accuracy and errors as above, and
/// InvalidArgument ("grid.ny").
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, PlaneStrain body,
                                   std::span<const std::array<double, 3>> points, Observer& observer);
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, PlaneStrain body,
                                   const StressBlock& block, Observer& observer);

/// Inside a body of layers: transfer functions of StressWaves, integrated along the edges of elements, and in the first
/// layer the half-space's closed form besides. Absolute accuracy 1e-9 of the largest traction. On the border of two
/// layers stresses are those of the upper one; xx, yy and xy jump there. Each depth takes some tens of milliseconds;
/// points that differ by whole elements share their coefficients. Errors as of the half-space, and below a rigid base.
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, const Layers& body,
                                   std::span<const std::array<double, 3>> points, Observer& observer);
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, const Layers& body,
                                   const StressBlock& block, Observer& observer);

/// Inside a body whose rows of elements are inclined by `angles` (rad, ny of them, from the y of the frame towards its
/// +z): tractions of each row act on another one as on its half-space, at the distance along the surface, turned by the
/// angle between both. So what a row bears of its own tractions is exact, and what it bears of others' knows curvature
/// to first order in depth over radius; of equal angles it is that of the plane. y of the points is the arc length, and
/// stresses are in the axes of the row above, whose angle is interpolated. Errors as above, and InvalidArgument
/// ("angles").
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, double nu,
                                   std::span<const double> angles, const SubsurfacePoints& points, Observer& observer);

/// Displacements inside a half-space (Johnson, sections 3.2 and 3.6), in the frame of the body. Relative accuracy 1e-13
/// times the square of the distance over the size of an element. Reports and throws as above, and for a body that is
/// rigid ("material").
SubsurfaceDisplacement subsurface_displacement(const Grid& grid, const SurfaceTractions& tractions,
                                               const Material& body, const SubsurfacePoints& points,
                                               Observer& observer);

/// Fills the arrays of invariants from the components, to some 1e-15 of the largest component at a point.
void find_invariants(SubsurfaceStress& stress);

}  // namespace contactd
