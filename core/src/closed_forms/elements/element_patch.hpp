// Describes a contact area made of elements for simplified models of rolling.
#pragma once

#include <optional>
#include <vector>

#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/kalker_coefficients.hpp"
#include "closed_forms/rolling_frame.hpp"

namespace contactd {

struct ElementPatch {
    std::vector<double> bound;  ///< friction bound over its coefficient, shape [ny, nx] (N/mm^2)
    SemiAxes axes;              ///< ellipse that determines flexibilities and creepage coefficients (mm)
    SemiAxes counted;           ///< ellipse that is equivalent to the elements (mm)
    double Fn = 0;              ///< (N)
    double area = 0;            ///< (mm^2)
    Material combined;          ///< of combined_material

    bool empty() const { return !(Fn > 0 && axes.a > 0 && axes.b > 0); }
};

/// Returns the ellipse with the area of the elements above zero and the ratio of their box: a = sqrt(area/pi
/// length/width), b = sqrt(area/pi width/length), along x and y. Returns nothing without such elements.
std::optional<SemiAxes> equivalent_ellipse(const Grid& grid, const std::vector<double>& values);

/// Returns the patch of a Hertzian contact on the grid. Its bound is Hertz's pressure, or the paraboloid with the same
/// force.
ElementPatch patch_of(const Grid& grid, const EllipticContact& contact, TractionBound bound);

/// Returns the patch of a contact of any shape, whose bound is its pressure (N/mm^2). It is empty without pressure.
ElementPatch patch_of(const Grid& grid, const std::vector<double>& pressure, const Material& combined);

/// Returns Kalker's coefficients for the axes along and across the rolling direction. Throws InvalidArgument ("gap")
/// for ratios beyond their table.
KalkerCoefficients coefficients_of(const SemiAxes& rolling, double nu, CreepageCoefficients from);

}  // namespace contactd
