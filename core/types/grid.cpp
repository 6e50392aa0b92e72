#include "contactd/grid.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "magnitude.hpp"
#include "number_text.hpp"

namespace contactd {

// Computes x y/hypot(y cos chi, x sin chi), without rounding errors along the axes.
double size_along(double chi, double x, double y) {
    const double c = std::cos(chi), s = std::sin(chi);
    return y * std::abs(c) >= x * std::abs(s) ? x / std::hypot(c, s * (x / y)) : y / std::hypot(s, c * (y / x));
}

int convenient_size(int n) {
    int least = 2 * n;
    for (const int odd : {1, 3, 5, 9, 15, 25}) {
        int size = odd;
        while (size < n) size *= 2;
        least = std::min(least, size);
    }
    return least;
}

void validate(const Grid& grid, const char* field) {
    const std::string name = field;
    const auto count = [&](int n, const char* which) {
        if (n < 1) throw InvalidArgument(name + which, "is " + std::to_string(n) + "; it must be at least 1");
    };
    const auto size = [&](double d, const char* which) {
        if (!std::isfinite(d) || d <= 0)
            throw InvalidArgument(name + which, "is " + number_text(d) + "; it must be a positive, finite length");
        check_magnitude(d, name + which);
    };
    const auto corner = [&](double c, const char* which) {
        if (!std::isfinite(c)) throw InvalidArgument(name + which, "is not finite; it must be a length");
    };
    count(grid.nx, ".nx");
    count(grid.ny, ".ny");
    if (grid.size() > max_grid_elements)
        throw InvalidArgument(name + ".nx", "times ny is " + std::to_string(grid.size()) + " elements, but at most " +
                                                std::to_string(max_grid_elements) + " are allowed");
    size(grid.dx, ".dx");
    size(grid.dy, ".dy");
    corner(grid.x0, ".x0");
    corner(grid.y0, ".y0");
}

}  // namespace contactd
