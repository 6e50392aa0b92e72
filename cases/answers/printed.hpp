// Holds solved contacts by the names under which CONTACT prints them.
#pragma once

#include "answers/solved.hpp"
#include "contactd/contact_file_run.hpp"
#include "contactd/read_contact_file.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_state.hpp"
#include "given/given.hpp"

namespace contactd::cases {

/// Returns the contact of a case of module 3.
ContactFilePatch printed_contact(const ContactCase& read, const Given& given, const Solved& solved);

/// Returns a patch of a wheel on its rail; `solved` is that of show_patch.
ContactFilePatch printed_patch(const WheelRailPatch& patch, const WheelRailSetup& setup, const WheelRailState& state,
                               const WheelRailSolution& solution, const Solved& solved);

/// Returns the numbers of all patches together.
ByName<double> printed_forces(const WheelRailState& state, const WheelRailSolution& solution);

}  // namespace contactd::cases
