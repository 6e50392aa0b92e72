// Influence coefficients that a user brings along, of one body or of the pair, for one element size.
#pragma once

#include <string>

#include "contactd/grid.hpp"
#include "contactd/ic_table.hpp"

namespace contactd {

struct GivenIcs {
    IcTable table;  ///< of a body, or of the pair (see pair_of); mm^3/N
    double dx = 0;  ///< element size along x that the table is for (mm)
    double dy = 0;  ///< element size along y (mm)

    bool operator==(const GivenIcs&) const = default;
};

/// Largest relative difference of element sizes that files with few digits may bring along.
inline constexpr double element_size_tolerance = 1e-6;
/// Above this the coupling of a pair is taken for real, below for rounding.
inline constexpr double coupling_tolerance = 1e-6;

/// How much normal and tangential contact influence each other: the largest |xz|, |zx|, |yz|, |zy| of the pair over its
/// zz at the origin. Zero for quasi-identical bodies (paper, section 4).
double coupling(const IcTable& pair);

/// Throws InvalidArgument naming dx, dy or table of `field` when no contact problem on `grid` can be solved with them:
/// element sizes that are not the grid's (by more than element_size_tolerance), too few offsets, a value that is not
/// finite, or xx, yy, zz that are not positive at the origin and largest there, as those of every elastic body are.
void validate(const GivenIcs& ics, const Grid& grid, const std::string& field);

}  // namespace contactd
