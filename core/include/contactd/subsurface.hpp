// Computes stresses inside a half-space, or a body of layers, under the tractions of a contact (Love 1929; Johnson,
// Contact Mechanics, sections 3.1 and 3.2; Kalker 1990, section 5.A). Tractions are constant on each element. Those of
// bilinear coefficients are treated as constant, with the values at the element centres.
#pragma once

#include <array>
#include <span>

#include "contactd/grid.hpp"
#include "contactd/layers.hpp"
#include "contactd/material.hpp"
#include "contactd/observer.hpp"
#include "contactd/subsurface_stress.hpp"

namespace contactd {

/// Creates the tractions on a body from results of a contact problem: pressure (> 0 in compression) and tractions on
/// the upper body.
SurfaceTractions tractions_on(ContactBody body, std::span<const double> pressure, std::span<const double> traction_x,
                              std::span<const double> traction_y);

/// Returns the stresses at points. `nu` is the body's Poisson's ratio; its shear modulus has no effect. The absolute
/// accuracy is 1e-11 of the largest traction. On the surface the values are the limits from below. At an edge of an
/// element, where tractions jump, they are the mean of both sides. At logarithmic singularities (beside a jump of the
/// tangential traction, at corners), they are the values at a distance of a millionth of the element. At depths below
/// one element size, the results show the steps of the tractions. Reports the stage "subsurface". Throws
/// InvalidArgument ("tractions.x", "nu", "points", "block.z", ...) and Cancelled.
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, double nu,
                                   std::span<const std::array<double, 3>> points, Observer& observer);

/// Returns the stresses on a block. Coordinates that differ by whole elements share convolutions, one for
/// every depth and stress, which makes many points cheap. Memory is a multiple of that of the points and
/// elements.
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, double nu,
                                   const StressBlock& block, Observer& observer);

/// Describes a half-space under a line contact: tractions are infinite and constant along y, and strains along y are
/// zero.
struct PlaneStrain {
    double nu = 0;  ///< Poisson's ratio; it only affects yy
};

/// Returns the stresses inside it, by line forces integrated over the elements (Johnson, sections 2.2 and 2.3);
/// tractions along y cause anti-plane shear. The grid has one row; dy and the points' y are not used. Accuracy and
/// errors are as above, with InvalidArgument ("grid.ny") in addition.
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, PlaneStrain body,
                                   std::span<const std::array<double, 3>> points, Observer& observer);
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, PlaneStrain body,
                                   const StressBlock& block, Observer& observer);

/// Returns the stresses inside a body of layers: transfer functions of StressWaves, integrated along the edges of
/// elements, plus the half-space's closed form in the first layer. The absolute accuracy is 1e-9 of the largest
/// traction. At the interface of two layers, stresses are those of the upper one; xx, yy and xy jump there. Each depth
/// takes some tens of milliseconds; points that differ by whole elements share their coefficients. Errors are those of
/// the half-space; points below the top of a rigid base are invalid, too.
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, const Layers& body,
                                   std::span<const std::array<double, 3>> points, Observer& observer);
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, const Layers& body,
                                   const StressBlock& block, Observer& observer);

/// Returns the stresses inside a body whose rows of elements are inclined by `angles` (rad, ny of them, from the y of
/// the frame towards its +z). Tractions of each row act on another one as on its half-space, at the distance along the
/// surface, rotated by the angle between both. Stresses by a row's own tractions are exact; those by other rows include
/// curvature to first order in depth over radius. With equal angles, they are those of the plane. y of the points is
/// the arc length, and stresses are in the axes of the row above, whose angle is interpolated. Errors are as above,
/// with InvalidArgument ("angles") in addition.
SubsurfaceStress subsurface_stress(const Grid& grid, const SurfaceTractions& tractions, double nu,
                                   std::span<const double> angles, const SubsurfacePoints& points, Observer& observer);

/// Returns displacements inside a half-space (Johnson, sections 3.2 and 3.6), in the frame of the body. The relative
/// accuracy is 1e-13 times the square of the distance over the size of an element. Reports and throws as above, and for
/// a rigid body ("material").
SubsurfaceDisplacement subsurface_displacement(const Grid& grid, const SurfaceTractions& tractions,
                                               const Material& body, const SubsurfacePoints& points,
                                               Observer& observer);

/// Computes the arrays of invariants from the components, to about 1e-15 of the largest component at a point.
void find_invariants(SubsurfaceStress& stress);

}  // namespace contactd
