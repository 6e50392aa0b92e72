// The messages of contact_file.* (docs/contact-files.md).
#pragma once

#include <cstddef>

#include <nlohmann/json.hpp>

#include "contactd/read_contact_file.hpp"
#include "contactd/read_contact_slices.hpp"

namespace contactd::proto {

nlohmann::json encode_contact_case(const ContactCase& read);
/// Returns the count of numbers in the message of a case.
std::size_t numbers_of(const ContactCase& read);

nlohmann::json encode_contact_slices(const ContactSlices& read);

}  // namespace contactd::proto
