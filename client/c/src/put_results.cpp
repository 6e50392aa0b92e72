#include "put_results.hpp"

#include <algorithm>
#include <cstring>

#include "arguments.hpp"

namespace contactd::c {

void put_areas(const Areas& area, double* in_contact, double* adhesion, double* slip) {
    given(in_contact, "in_contact"), given(adhesion, "adhesion"), given(slip, "slip");
    *in_contact = area.contact;
    *adhesion = area.adhesion;
    *slip = area.slip;
}

void put_counts(const Counts& counts, std::int32_t* in_contact, std::int32_t* adhesion, std::int32_t* slip,
                std::int32_t* border) {
    given(in_contact, "in_contact"), given(adhesion, "adhesion"), given(slip, "slip"), given(border, "border");
    *in_contact = counts.contact;
    *adhesion = counts.adhesion;
    *slip = counts.slip;
    *border = counts.border;
}

void put_text(const std::string& source, char* text, std::int32_t length) {
    given(text, "text");
    if (length < 1) throw InvalidArgument("length", "is " + std::to_string(length) + "; it must be at least 1");
    const std::size_t kept = std::min(source.size(), static_cast<std::size_t>(length) - 1);
    std::memcpy(text, source.data(), kept);
    text[kept] = '\0';
}

void put_warning(const std::vector<std::string>& warnings, std::int32_t index, char* text, std::int32_t length) {
    if (index < 0 || static_cast<std::size_t>(index) >= warnings.size())
        throw InvalidArgument(
            "index", "is " + std::to_string(index) + "; there are " + std::to_string(warnings.size()) + " warnings");
    put_text(warnings[static_cast<std::size_t>(index)], text, length);
}

}  // namespace contactd::c
