// A contact area made of elements, as simplified models of rolling see it.
#pragma once

#include <optional>
#include <vector>

#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/kalker_coefficients.hpp"
#include "closed_forms/rolling_frame.hpp"

namespace contactd {

struct ElementPatch {
    std::vector<double> bound;  ///< what friction bears per unit of its coefficient, shape [ny, nx] (N/mm^2)
    SemiAxes axes;              ///< of the ellipse whose flexibilities and creepage coefficients are taken (mm)
    SemiAxes counted;           ///< of the ellipse that is equivalent to the elements (mm)
    double Fn = 0;              ///< (N)
    double area = 0;            ///< (mm^2)
    Material combined;          ///< of combined_material

    bool empty() const { return !(Fn > 0 && axes.a > 0 && axes.b > 0); }
};

/// The ellipse with the area of the elements above zero and the ratio of their box: a = sqrt(area/pi length/width), b =
/// sqrt(area/pi width/length), along x and y; nothing without such elements.
std::optional<SemiAxes> equivalent_ellipse(const Grid& grid, const std::vector<double>& values);

/// The ellipse of a Hertzian contact on the grid; its bound is that of Hertz, or the paraboloid with the same force.
ElementPatch patch_of(const Grid& grid, const EllipticContact& contact, TractionBound bound);

/// A contact of any shape, whose bound is its pressure (N/mm^2). Empty without pressure.
ElementPatch patch_of(const Grid& grid, const std::vector<double>& pressure, const Material& combined);

/// Kalker's coefficients of the axes as seen in rolling. Throws InvalidArgument ("gap") for ratios beyond their table.
KalkerCoefficients coefficients_of(const SemiAxes& rolling, double nu, CreepageCoefficients from);

}  // namespace contactd
