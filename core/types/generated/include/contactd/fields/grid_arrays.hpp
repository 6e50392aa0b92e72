// Written by ./dev generate from proto/schema: edit it there.

#pragma once

#include <array>

#include "contactd/history.hpp"

namespace contactd {

/// Arrays of numbers in the order of SolutionField; null for the element division.
extern const std::array<std::vector<double> ContactSolution::*, 16> solution_arrays;

/// Arrays that a step passes on to the next, in the order of SurfaceState.
extern const std::array<HistoryArray, 5> history_arrays;

}  // namespace contactd
