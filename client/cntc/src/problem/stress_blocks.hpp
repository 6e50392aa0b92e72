// Blocks of points inside the bodies, and the stresses there.
#pragma once

#include <vector>

#include "problem/contact_case.hpp"

namespace contactd::cntc {

/// An array as a caller passes it.
struct GivenArray {
    const double* values;
    const int* count;
};

/// `kind`: x and y are those of all element centres (1, 5), of elements first, step, last (2, 6) or listed (3, 7), by
/// numbers from 1 on, or coordinates (9); z is [number, first, step] up to 3, and coordinates from 5 on. Throws
/// Refused for other kinds, and what is too short or no number.
GivenBlock read_block(int kind, const GivenArray& x, const GivenArray& y, const GivenArray& z, double length);

/// Its points, z > 0 inside the upper body (mm).
StressBlock block_points(const GivenBlock& block, const Grid& grid);

/// Stresses in the frame of the contact. At z = 0 they are those of the upper body.
SolvedBlock solve_block(const GivenBlock& block, const Solved& solved);

/// One column of the answer, a value for each point, x fastest: 1 to 3 x, y, z; 4 to 6 displacements; 7 to 9 the mean
/// of the normal stresses, von Mises' and Tresca's stress; 10 to 12 principal stresses, largest first; 13 to 21 xx, yx,
/// zx, xy, ... zz. Throws Refused for others.
std::vector<double> block_column(const SolvedBlock& block, int column, const Units& units);

}  // namespace contactd::cntc
