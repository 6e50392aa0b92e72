// A block of points below the surface as a program sets it.
#pragma once

#include "answers/stress_blocks.hpp"

namespace contactd::cntc {

using namespace cases;

/// An array as a caller passes it.
struct GivenArray {
    const double* values;
    const int* count;
};

/// x and y by the kind of the block; z is [number, first, step] up to the kind 3, and coordinates from 5 on. Throws
/// Refused for other kinds, and what is too short or no number.
GivenBlock read_block(int kind, const GivenArray& x, const GivenArray& y, const GivenArray& z, double length);

}  // namespace contactd::cntc
