// Parts of a solution, as they are put into the caller's memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd::c {

/// Each throws InvalidArgument naming what is NULL, or does not fit ("length", "index").
void put_areas(const Areas& area, double* in_contact, double* adhesion, double* slip);
void put_counts(const Counts& counts, std::int32_t* in_contact, std::int32_t* adhesion, std::int32_t* slip,
                std::int32_t* border);
/// `source`, cut to what `length` bytes hold with their end.
void put_text(const std::string& source, char* text, std::int32_t length);
void put_warning(const std::vector<std::string>& warnings, std::int32_t index, char* text, std::int32_t length);

}  // namespace contactd::c
