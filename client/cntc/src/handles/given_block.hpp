// A block of points below the surface, as a program sets it.
#pragma once

#include "answers/stress_blocks.hpp"

namespace contactd::cntc {

using namespace cases;

/// An array as passed by a caller.
struct GivenArray {
    const double* values;
    const int* count;
};

/// Reads a block: x and y according to its kind, and z as [number, first, step] for kinds up to 3, as coordinates from
/// 5 on. Throws Refused for other kinds, and for arrays that are too short or contain numbers that are not finite.
GivenBlock read_block(int kind, const GivenArray& x, const GivenArray& y, const GivenArray& z, double length);

}  // namespace contactd::cntc
