// Results with one number an element, as CONTACT prints them. An empty array stands for zeros.
#pragma once

#include <vector>

#include "answers/solved.hpp"

namespace contactd::cases {

/// The undeformed distance (mm).
std::vector<double> distance_of(const Solved& solved);

/// The rigid slip of the motion that was given, with the extra rigid slip: of rolling relative, of a shift in mm.
RigidSlip rigid_slip_of(const Solved& solved);

/// Coefficients of friction at the slip, or the temperature, that was found.
std::vector<double> friction_of(const Solved& solved);

/// Displacements with zeros outside the contact.
std::vector<double> in_contact(std::vector<double> displacement, const ContactSolution& solution);

}  // namespace contactd::cases
