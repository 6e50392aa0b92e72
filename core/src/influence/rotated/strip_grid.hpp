// Describes strips of a section and the elements on them.
#pragma once

#include <span>

#include "contactd/section.hpp"

namespace contactd {

struct StripGrid {
    std::span<const StripFrame> frames;
    double ds = 0;         ///< arc length of a strip (mm)
    double perimeter = 0;  ///< length of a smooth closed curve, where the shorter way round counts (mm); 0: an open one
    double dx = 0;         ///< length of an element along x (mm)
    int nx = 0;            ///< offsets 0..nx-1 along x
};

}  // namespace contactd
