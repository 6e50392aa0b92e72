// Holds results with one number for each element, as CONTACT prints them. An empty array represents zeros.
#pragma once

#include <vector>

#include "answers/solved.hpp"

namespace contactd::cases {

/// Returns the undeformed distance (mm).
std::vector<double> distance_of(const Solved& solved);

/// Returns the rigid slip of the given motion plus the extra rigid slip. It is relative in rolling, and in mm for
/// shifts.
RigidSlip rigid_slip_of(const Solved& solved);

/// Returns the friction coefficients at the computed slip or temperature.
std::vector<double> friction_of(const Solved& solved);

/// Returns the displacements with zeros outside the contact.
std::vector<double> in_contact(std::vector<double> displacement, const ContactSolution& solution);

}  // namespace contactd::cases
