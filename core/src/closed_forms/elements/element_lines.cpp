#include "element_lines.hpp"

#include <string>

#include "types/number_text.hpp"

namespace contactd {

ElementLines::ElementLines(const Grid& grid, const RollingFrame& frame)
    : grid_(grid), frame_(frame), rows_(frame.s == 0), forwards_((rows_ ? frame.c : frame.s) > 0) {
    if (frame.s != 0 && frame.c != 0)
        throw InvalidArgument("friction.rolling.chi",
                              "is not along an axis of the grid (cosine " + number_text(frame.c) +
                                  "); simplified models on elements roll along rows or columns: use a multiple of "
                                  "pi/2, or model full, which supports any direction");
}

std::size_t ElementLines::element(int line, int place) const {
    const int ix = rows_ ? cell(place) : line, iy = rows_ ? line : cell(place);
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid_.nx) + static_cast<std::size_t>(ix);
}

double ElementLines::along(int place) const {
    return rows_ ? frame_.c * grid_.x(cell(place)) : frame_.s * grid_.y(cell(place));
}

double ElementLines::across(int line) const {
    return rows_ ? frame_.c * grid_.y(line) : -frame_.s * grid_.x(line);
}

}  // namespace contactd
