// Defines a rectangle of elements of a grid.
#pragma once

#include <cstddef>

namespace contactd {

/// The box contains the columns first_x .. first_x + nx - 1, and the rows first_y .. first_y + ny - 1.
struct ElementBox {
    int first_x = 0, first_y = 0, nx = 0, ny = 0;

    std::size_t size() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    bool operator==(const ElementBox&) const = default;
};

}  // namespace contactd
