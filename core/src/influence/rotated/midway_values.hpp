// Computes values of half-spaces midway between strips, and converts them to the axes of the strips.
#pragma once

#include <cstddef>
#include <vector>

#include "contactd/observer.hpp"
#include "contactd/strip_table.hpp"
#include "influence/rotated/strip_grid.hpp"
#include "influence/rotated/strip_values.hpp"

namespace contactd {

/// Returns values midway between two strips, which depend only on their distance: n of each distance in strips, from 0
/// on, by `integrals(s, k)`, k = 0..n-1.
template <class Integrals>
std::vector<NineValues> midway_values(const StripGrid& grid, double nu, std::size_t n, const Observer& observer,
                                      const Integrals& integrals) {
    std::vector<NineValues> values;
    values.reserve(grid.frames.size() * n);
    for (int distance = 0; distance < static_cast<int>(grid.frames.size()); ++distance) {
        observer.throw_if_cancelled();
        const double s = view_of(grid.frames, grid.ds, grid.perimeter, distance, 0).s;
        for (std::size_t k = 0; k < n; ++k) values.push_back(nine_values(integrals(s, k), nu));
    }
    return values;
}

/// Returns the values times a factor in the axes of the strips, shape [3, 3, strips, strips, n].
UnsetArray in_strip_axes(const StripGrid& grid, const std::vector<NineValues>& midway, double factor,
                         const Observer& observer);

/// Returns them as a table of grid.nx offsets.
StripTable midway_table(const StripGrid& grid, const std::vector<NineValues>& midway, double factor,
                        const Observer& observer);

}  // namespace contactd
