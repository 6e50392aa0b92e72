#include "influence/rotated/rotated_half_space.hpp"

#include <cstddef>

#include "influence/half_space_model.hpp"
#include "influence/rotated/midway_values.hpp"

namespace contactd {

StripTable rotated_half_space(const StripGrid& grid, const Material& material, LoadShape load, double shift,
                              const Observer& observer) {
    const HalfSpaceModel model(load);
    const auto midway =
        midway_values(grid, material.nu, static_cast<std::size_t>(grid.nx), observer, [&](double s, std::size_t k) {
            return model.integrals(static_cast<double>(k) * grid.dx + shift, s, grid.dx, grid.ds);
        });
    return midway_table(grid, midway, 1 / material.G, observer);
}

}  // namespace contactd
