// Warns of shifts and amplitudes of a wheelset that are probably meant in another unit.
#pragma once

#include <string>
#include <vector>

#include "contactd/conicity.hpp"

namespace contactd {

/// Returns complete sentences that begin with the field, "contacts.shifts".
std::vector<std::string> unit_warnings(const ContactsRequest& request);

/// Returns complete sentences that begin with the field, "conicity.amplitudes" or "conicity.contact_distance".
std::vector<std::string> unit_warnings(const ConicityRequest& request);

}  // namespace contactd
