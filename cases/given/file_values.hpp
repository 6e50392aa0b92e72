// The values of a case of an input file of CONTACT, as those that problems are made of.
#pragma once

#include <string>

#include "contactd/read_contact_file.hpp"
#include "given/given.hpp"
#include "given/given_rail.hpp"

namespace contactd::cases {

/// Sets what a case of basic contact has. Files that it names lie relative to the folder. What a case does not have
/// stays: the digits R and S, and a time step. Throws NotCovered, and InvalidArgument, with `given` set in part.
void set_basic_case(Given& given, const ContactCase& read, const std::string& folder);

/// Sets what a case of a wheel on a rail has. Throws as set_basic_case does.
void set_rail_case(Given& given, GivenRail& rail, const ContactCase& read, const std::string& folder);

}  // namespace contactd::cases
