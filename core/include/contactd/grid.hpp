// Defines the potential contact area: a rectangle of nx x ny cell-centred elements.
#pragma once

#include <cstddef>

namespace contactd {

/// Element (ix, iy), 0 <= ix < nx, 0 <= iy < ny, has index iy*nx + ix. Arrays over the grid have shape [ny, nx] in C
/// order.
struct Grid {
    int nx = 0;     ///< number of elements along x, >= 1
    int ny = 0;     ///< number of elements along y, >= 1
    double dx = 0;  ///< element size along x (mm), > 0
    double dy = 0;  ///< element size along y (mm), > 0
    double x0 = 0;  ///< x of the lower left corner of element (0, 0) (mm)
    double y0 = 0;  ///< y of the same corner (mm)

    /// Returns nx x ny elements of size dx x dy centred at the origin. (Python's Grid.centred takes the size of the
    /// whole.)
    static Grid of_elements(int nx, int ny, double dx, double dy) {
        return {nx, ny, dx, dy, -0.5 * nx * dx, -0.5 * ny * dy};
    }

    [[deprecated("takes the size of an element, unlike Python's, which takes the whole size; use of_elements")]]
    static Grid centred(int nx, int ny, double dx, double dy) {
        return of_elements(nx, ny, dx, dy);
    }

    std::size_t size() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
    double x(int ix) const { return x0 + (ix + 0.5) * dx; }  ///< centre of column ix (mm)
    double y(int iy) const { return y0 + (iy + 0.5) * dy; }  ///< centre of row iy (mm)
    double element_area() const { return dx * dy; }          ///< (mm^2)

    bool operator==(const Grid&) const = default;
};

/// Returns the extent at the angle chi from the x axis of an object with the lengths `x` and `y` along the axes: exact
/// for an ellipse with these diameters, and along the axes of a rectangle. A square has one size in all directions, and
/// rotating the object and chi by a right angle has no effect.
double size_along(double chi, double x, double y);

/// Returns a number of elements >= n (n >= 1) along an axis for which transforms are fast. There are few such numbers,
/// so that their grids need few operators.
int convenient_size(int n);

/// The limit on the elements of one grid bounds memory before anything is allocated.
inline constexpr std::size_t max_grid_elements = 4'000'000;

/// Throws InvalidArgument, which names `field`.nx, .ny, .dx, .dy, .x0 or .y0, if the grid is invalid.
void validate(const Grid& grid, const char* field);

}  // namespace contactd
