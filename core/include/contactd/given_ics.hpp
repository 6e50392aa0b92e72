// Holds influence coefficients provided by a user, of one body or of the pair, for one element size.
#pragma once

#include <string>

#include "contactd/grid.hpp"
#include "contactd/ic_table.hpp"

namespace contactd {

struct GivenIcs {
    IcTable table;  ///< table of a body, or of the pair (see pair_of); mm^3/N
    double dx = 0;  ///< element size of the table along x (mm)
    double dy = 0;  ///< element size along y (mm)

    bool operator==(const GivenIcs&) const = default;
};

/// Element sizes may differ by this relative amount, because files may have few digits.
inline constexpr double element_size_tolerance = 1e-6;
/// Coupling of a pair below this value is treated as rounding errors.
inline constexpr double coupling_tolerance = 1e-6;

/// Returns the coupling of normal and tangential contact: the largest |xz|, |zx|, |yz|, |zy| of the pair over its zz at
/// the origin. It is zero for quasi-identical bodies (paper, section 4).
double coupling(const IcTable& pair);

/// Throws InvalidArgument, which names dx, dy or table of `field`, if they are unsuitable for a contact problem on
/// `grid`. They are unsuitable if element sizes differ by more than element_size_tolerance, offsets are missing, or a
/// value is not finite. xx, yy and zz must be positive and largest at the origin, as for every elastic body.
void validate(const GivenIcs& ics, const Grid& grid, const std::string& field);

}  // namespace contactd
