// Parts of a solution, as contacts and patches of wheels put them into the caller's memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd::c {

/// Of a word that is no array of doubles, throws InvalidArgument ("array"), naming the function that reads the
/// division.
SolutionField double_field(std::int32_t array, const char* reads_division);
const std::vector<double>& array_of(const ContactSolution& solution, SolutionField field);

/// Each throws InvalidArgument naming what is NULL, or does not fit ("length", "index").
void put_areas(const Areas& area, double* in_contact, double* adhesion, double* slip);
void put_counts(const Counts& counts, std::int32_t* in_contact, std::int32_t* adhesion, std::int32_t* slip,
                std::int32_t* border);
/// `source` may be empty: zeros.
void put_array(const std::vector<double>& source, const Grid& grid, double* values, std::int32_t length);
void put_division(const ContactSolution& solution, const Grid& grid, std::int32_t* division, std::int32_t length);
/// `source`, cut to what `length` bytes hold with their end.
void put_text(const std::string& source, char* text, std::int32_t length);
void put_warning(const std::vector<std::string>& warnings, std::int32_t index, char* text, std::int32_t length);

}  // namespace contactd::c
