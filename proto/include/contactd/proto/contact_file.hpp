// The messages of contact_file.read (docs/contact-files.md).
#pragma once

#include <cstddef>

#include <nlohmann/json.hpp>

#include "contactd/read_contact_file.hpp"

namespace contactd::proto {

nlohmann::json encode_contact_case(const ContactCase& read);
/// How many numbers the message of a case has.
std::size_t numbers_of(const ContactCase& read);

}  // namespace contactd::proto
