// Computes the compliance of a half-space under a tangential traction distributed like Hertz's pressure over an
// ellipse.
#pragma once

#include "contactd/gap.hpp"
#include "contactd/material.hpp"
#include "elliptic_contact.hpp"

namespace contactd {

/// Describes the difference of both bodies' displacements inside the ellipse, under the force F along direction i: u_i
/// = F (centre_i - along_i x^2 - ... y^2). `combined` is as in combined_material.
struct EllipseCompliance {
    double centre_x, centre_y;  ///< (mm/N)
    double along_x, along_y;    ///< coefficients of x^2 in u_x and in u_y (1/(N mm))
    /// Scales areas: one k times as large moves under k^n F (n of force_power) by k^2 F centre_i (1 - logarithm ln k).
    /// It is zero for ellipses, which are similar to each other. Strips are not similar, because of the datum.
    double logarithm = 0;
};

EllipseCompliance ellipse_compliance(const SemiAxes& axes, const Material& combined);

/// Returns the compliance of a contact, which may be a strip. `axes` are those of the contact, in the frame of x.
EllipseCompliance compliance_of(const EllipticContact& contact, const SemiAxes& axes);

}  // namespace contactd
