// The compliance of a half-space under a tangential traction spread like Hertz's pressure over an ellipse.
#pragma once

#include "contactd/gap.hpp"
#include "contactd/material.hpp"
#include "elliptic_contact.hpp"

namespace contactd {

/// Inside the ellipse, under the force F along direction i: u_i = F (centre_i - along_i x^2 - ... y^2), the difference
/// of both bodies' displacements; `combined` as in combined_material.
struct EllipseCompliance {
    double centre_x, centre_y;  ///< (mm/N)
    double along_x, along_y;    ///< of x^2 in u_x and in u_y (1/(N mm))
    /// An area k times as large moves under k^n F (n of force_power) by k^2 F centre_i (1 - logarithm ln k): zero of
    /// ellipses, which are similar to each other. Strips are not, by the datum.
    double logarithm = 0;
};

EllipseCompliance ellipse_compliance(const SemiAxes& axes, const Material& combined);

/// Returns the compliance of a contact, also of a strip; `axes` are its own, in the frame that x is of.
EllipseCompliance compliance_of(const EllipticContact& contact, const SemiAxes& axes);

}  // namespace contactd
