// Computes Hertzian contact of paraboloids over an ellipse (Johnson, Contact Mechanics, section 4.2), in closed form.
// The only parameter of the bodies is their compliance c = 1/E* = (1-nu1)/(2 G1) + (1-nu2)/(2 G2) (mm^2/N), to which a
// rigid body adds nothing.
#pragma once

#include "contactd/gap.hpp"

namespace contactd {

/// Without contact, all values except the approach are zero.
struct HertzContact {
    double a = 0;         ///< semi-axis along x (mm)
    double b = 0;         ///< semi-axis along y (mm), infinite for a line contact
    double pmax = 0;      ///< at the centre (N/mm^2)
    double approach = 0;  ///< (mm)
    double Fn = 0;        ///< (N)
};

/// Return the contact for a force or an approach. Both radii are positive and finite, and either may be the larger.
/// There is no contact if Fn or the approach is not positive. Throw InvalidArgument ("gap.Rx", "gap.Ry", "bodies",
/// "Fn", "approach") for other values.
HertzContact hertz_of_force(const Paraboloid& gap, double compliance, double Fn);
HertzContact hertz_of_approach(const Paraboloid& gap, double compliance, double approach);

/// Describes cylinders with their axes along y, pressed together uniformly along y.
struct CylinderGap {
    double R = 0;       ///< combined radius (mm)
    double length = 0;  ///< length along y to which forces refer (mm)
    double datum = 0;   ///< datum of LineContactSpec: the distance at which displacements vanish (mm)
};

/// Return the line contact of cylinders (Johnson, sections 2.5 and 4.2(c)): a^2 = 4 Fn R c/(pi length), b infinite, and
/// the approach a^2/(2 R) (ln(2 datum/a) + 1/2). Throw InvalidArgument ("gap.paraboloid.Rx", "bodies", "Fn",
/// "approach"), and ("ics.line_contact.datum") if the contact is wider than the datum.
HertzContact hertz_of_line_force(const CylinderGap& gap, double compliance, double Fn);
HertzContact hertz_of_line_approach(const CylinderGap& gap, double compliance, double approach);

/// Returns the contact with these semi-axes, either of which may be the longer, and this force. Throws InvalidArgument
/// ("gap.a", "gap.b", "bodies", "Fn") if a value is not positive and finite.
HertzContact hertz_of_semi_axes_and_force(const SemiAxes& axes, double compliance, double Fn);
/// Returns the contact with these semi-axes and this approach. Errors name "approach".
HertzContact hertz_of_semi_axes_and_approach(const SemiAxes& axes, double compliance, double approach);

/// Returns the radii that produce this contact, which a gap given by semi-axes represents. Throws as above.
Paraboloid radii_of_force(const SemiAxes& axes, double compliance, double Fn);
/// Returns the radii for an approach instead of a force. The bodies do not matter then.
Paraboloid radii_of_approach(const SemiAxes& axes, double approach);

}  // namespace contactd
