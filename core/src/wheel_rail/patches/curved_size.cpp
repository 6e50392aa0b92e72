#include "wheel_rail/patches/curved_size.hpp"

#include <string>

#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd {

void check_curved_size(const Grid& grid) {
    constexpr double most_values = 5e7;  // limit of each of nine components: 3.6 GB in total
    if (static_cast<double>(grid.nx) * grid.ny * grid.ny > most_values)
        throw InvalidArgument("dy", "is " + number_text(grid.dy) + ", which results in a patch of " +
                                        std::to_string(grid.ny) + " rows of " + std::to_string(grid.nx) +
                                        " elements; if coefficients differ between rows, the square of the number of "
                                        "rows times the elements of a row must not exceed 5e7");
}

}  // namespace contactd
