#include "put_results.hpp"

#include <algorithm>
#include <cstring>

#include "arguments.hpp"

namespace contactd::c {
namespace {

void check_length(const Grid& grid, std::int32_t length) {
    if (length < 0 || static_cast<std::size_t>(length) != grid.size())
        throw InvalidArgument(
            "length", "is " + std::to_string(length) + "; the grid has " + std::to_string(grid.size()) + " elements");
}

}  // namespace

SolutionField double_field(std::int32_t array, const char* reads_division) {
    if (array == CONTACTD_DIVISION)
        throw InvalidArgument("array", std::string("is CONTACTD_DIVISION; ") + reads_division + " reads it");
    return static_cast<SolutionField>(array);
}

const std::vector<double>& array_of(const ContactSolution& solution, SolutionField field) {
    switch (field) {
        case SolutionField::pressure:
            return solution.pressure;
        case SolutionField::traction_x:
            return solution.traction_x;
        case SolutionField::traction_y:
            return solution.traction_y;
        case SolutionField::slip_x:
            return solution.slip_x;
        default:
            return solution.slip_y;
    }
}

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

void put_array(const std::vector<double>& source, const Grid& grid, double* values, std::int32_t length) {
    check_length(grid, length);
    std::fill_n(values, length, 0.0);
    std::copy(source.begin(), source.end(), values);
}

void put_division(const ContactSolution& solution, const Grid& grid, std::int32_t* division, std::int32_t length) {
    check_length(grid, length);
    std::ranges::transform(solution.element_division, division,
                           [](ElementState state) { return static_cast<std::int32_t>(state); });
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
