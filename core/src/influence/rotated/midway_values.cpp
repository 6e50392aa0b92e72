#include "influence/rotated/midway_values.hpp"

namespace contactd {
namespace {

// Values that are odd along s change their signs at the opposite distance.
NineValues opposite(NineValues values) {
    for (const std::size_t odd : {1, 3, 5, 7}) values[odd] = -values[odd];
    return values;
}

}  // namespace

UnsetArray in_strip_axes(const StripGrid& grid, const std::vector<NineValues>& midway, double factor,
                         const Observer& observer) {
    const std::size_t strips = grid.frames.size(), n = midway.size() / strips, component = strips * strips * n;
    UnsetArray values(9 * component);
    for (std::size_t I = 0; I < strips; ++I) {
        observer.throw_if_cancelled();
        for (std::size_t J = 0; J < strips; ++J) {
            const StripAxes axes(
                view_of(grid.frames, grid.ds, grid.perimeter, static_cast<int>(I), static_cast<int>(J)).turn);
            const NineValues* of_pair = &midway[(I > J ? I - J : J - I) * n];
            for (std::size_t k = 0; k < n; ++k) {
                const NineValues rotated = axes(I < J ? opposite(of_pair[k]) : of_pair[k]);
                for (std::size_t ij = 0; ij < 9; ++ij)
                    values[ij * component + (I * strips + J) * n + k] = factor * rotated[ij];
            }
        }
    }
    return values;
}

StripTable midway_table(const StripGrid& grid, const std::vector<NineValues>& midway, double factor,
                        const Observer& observer) {
    StripTable table;
    table.nx = grid.nx;
    table.strips = static_cast<int>(grid.frames.size());
    table.values = in_strip_axes(grid, midway, factor, observer);
    return table;
}

}  // namespace contactd
