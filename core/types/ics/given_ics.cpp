#include "contactd/given_ics.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "contactd/fields/axis.hpp"
#include "types/magnitude.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using enum Axis;

std::string text_of(int nx, int ny) {
    return std::to_string(nx) + " x " + std::to_string(ny);
}

std::string place_of(Axis i, Axis j, int k, int l) {
    return std::string(name_of(i)) + std::string(name_of(j)) + " at the offset (" + std::to_string(k) + ", " +
           std::to_string(l) + ")";
}

void check_element_size(double size, double of_grid, const std::string& field, const char* axis) {
    if (std::abs(size - of_grid) <= element_size_tolerance * of_grid) return;
    throw InvalidArgument(field, "is " + number_text(size) + "; the grid's elements are " + number_text(of_grid) +
                                     " along " + axis + ", but a table is valid for one element size only");
}

// Squares of smaller numbers are below the range of a double.
constexpr double smallest_coefficient = 1e-100;

void check_size(const IcTable& table, const std::string& field) {
    for (const Axis i : {x, y, z})
        for (const Axis j : {x, y, z})
            for (int l = 0; l < table.ny; ++l)
                for (int k = 0; k < table.nx; ++k)
                    if (!(std::abs(table(i, j, k, l)) <= largest_magnitude))
                        throw InvalidArgument(field, "contains " + number_text(table(i, j, k, l)) + " for " +
                                                         place_of(i, j, k, l) +
                                                         "; every value must be finite, from -1e100 to 1e100");
}

/// A load does positive work on the displacement below it, and |A(k,l)| <= A(0,0) in a positive definite matrix A(i-j).
void check_is_elastic(const IcTable& table, Axis i, const std::string& field) {
    const double own = table(i, i, 0, 0);
    if (own <= 0)
        throw InvalidArgument(field, "contains " + number_text(own) + " for " + place_of(i, i, 0, 0) +
                                         "; it must be positive: a surface moves in the direction of its load");
    if (own < smallest_coefficient)
        throw InvalidArgument(
            field, "contains " + number_text(own) + " for " + place_of(i, i, 0, 0) + "; it must be at least 1e-100");
    const double most = own * (1 + 1e-9);
    for (int l = 0; l < table.ny; ++l)
        for (int k = 0; k < table.nx; ++k)
            if (std::abs(table(i, i, k, l)) > most)
                throw InvalidArgument(
                    field, "contains " + number_text(table(i, i, k, l)) + " for " + place_of(i, i, k, l) +
                               "; the value at (0, 0), the first in the table, must be the largest, but it is " +
                               number_text(own));
}

}  // namespace

double coupling(const IcTable& pair) {
    double largest = 0;
    for (const auto& [i, j] : {std::pair{x, z}, {z, x}, {y, z}, {z, y}})
        for (int l = 0; l < pair.ny; ++l)
            for (int k = 0; k < pair.nx; ++k) largest = std::max(largest, std::abs(pair(i, j, k, l)));
    return largest / pair(z, z, 0, 0);
}

void validate(const GivenIcs& ics, const Grid& grid, const std::string& field) {
    check_element_size(ics.dx, grid.dx, field + ".dx", "x");
    check_element_size(ics.dy, grid.dy, field + ".dy", "y");
    const std::string of_table = field + ".table";
    if (ics.table.nx < grid.nx || ics.table.ny < grid.ny)
        throw InvalidArgument(of_table, "has " + text_of(ics.table.nx, ics.table.ny) +
                                            " offsets; the grid needs at least as many as it has elements, " +
                                            text_of(grid.nx, grid.ny));
    check_size(ics.table, of_table);
    for (const Axis i : {x, y, z}) check_is_elastic(ics.table, i, of_table);
}

}  // namespace contactd
