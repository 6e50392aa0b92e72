// Takes the values of a case of a CONTACT input file.
#pragma once

#include <string>

#include "contactd/read_contact_file.hpp"
#include "given/given.hpp"
#include "given/given_rail.hpp"
#include "given/named_files.hpp"

namespace contactd::cases {

/// Sets the values of a case of basic contact. `files` are those that it may name. Values that a case does not
/// contain remain unchanged: the digits R and S, and the time step. If it throws NotCovered or InvalidArgument, `given`
/// is set in part.
void set_basic_case(Given& given, const ContactCase& read, const NamedFiles& files);

/// Returns a sentence if a case of basic contact has a rolling direction CHI that its method of solution cannot take,
/// as in CONTACT; otherwise none.
std::string warning_of_direction(const ContactCase& read);

/// Sets the values of a case of a wheel on a rail. Throws the same errors as set_basic_case.
void set_rail_case(Given& given, GivenRail& rail, const ContactCase& read, const NamedFiles& files);

}  // namespace contactd::cases
