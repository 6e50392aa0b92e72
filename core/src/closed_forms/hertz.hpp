// Hertzian contact of paraboloids over an ellipse (Johnson, Contact Mechanics, section 4.2), in closed form.
// Bodies enter by their compliance c = 1/E* = (1-nu1)/(2 G1) + (1-nu2)/(2 G2) (mm^2/N): a rigid body adds nothing.
#pragma once

#include "contactd/gap.hpp"

namespace contactd {

/// All zero but the approach when there is no contact.
struct HertzContact {
    double a = 0;         ///< semi-axis along x (mm)
    double b = 0;         ///< semi-axis along y (mm), infinite of a line contact
    double pmax = 0;      ///< at the centre (N/mm^2)
    double approach = 0;  ///< (mm)
    double Fn = 0;        ///< (N)
};

/// Both radii are positive and finite, either may be the larger; no contact where Fn or the approach is not positive.
/// Throws InvalidArgument ("gap.Rx", "gap.Ry", "bodies", "Fn", "approach") otherwise.
HertzContact hertz_of_force(const Paraboloid& gap, double compliance, double Fn);
HertzContact hertz_of_approach(const Paraboloid& gap, double compliance, double approach);

/// Cylinders with their axes along y, pressed together where nothing changes along it.
struct CylinderGap {
    double R = 0;       ///< combined radius (mm)
    double length = 0;  ///< along y, that forces are counted over (mm)
    double datum = 0;   ///< of LineContactSpec: the distance at which displacements vanish (mm)
};

/// Their line contact (Johnson, sections 2.5 and 4.2(c)): a^2 = 4 Fn R c/(pi length), b infinite, and the approach
/// a^2/(2 R) (ln(2 datum/a) + 1/2). Throws InvalidArgument ("gap.paraboloid.Rx", "bodies", "Fn", "approach"), and
/// ("ics.line_contact.datum") where the contact is wider than it.
HertzContact hertz_of_line_force(const CylinderGap& gap, double compliance, double Fn);
HertzContact hertz_of_line_approach(const CylinderGap& gap, double compliance, double approach);

/// The contact with these semi-axes, either of which may be the longer, and the force. Throws InvalidArgument
/// ("gap.a", "gap.b", "bodies", "Fn") where a value is not positive and finite.
HertzContact hertz_of_semi_axes_and_force(const SemiAxes& axes, double compliance, double Fn);
/// Takes the approach instead of the force; errors name "approach".
HertzContact hertz_of_semi_axes_and_approach(const SemiAxes& axes, double compliance, double approach);

/// The radii that make this contact: what a gap given by semi-axes stands for. Throws as above.
Paraboloid radii_of_force(const SemiAxes& axes, double compliance, double Fn);
/// Takes the approach instead of the force; the bodies do not matter then.
Paraboloid radii_of_approach(const SemiAxes& axes, double approach);

}  // namespace contactd
