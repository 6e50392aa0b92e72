#include "contactd/rotated_strips.hpp"

#include "geometry/section/section_geometry.hpp"
#include "influence/rotated/rotated_half_space.hpp"

namespace contactd {

StripTable rotated_strips(const Section& section, const Grid& grid, const Material& material, LoadShape load,
                          double shift, const std::string& field, const Observer& observer) {
    validate(grid, "grid");
    const geometry::SectionGeometry geometry(section, grid.ny, grid.dy, field);
    const auto frames = geometry.frames();
    return rotated_half_space({frames, grid.dy, geometry.perimeter(), grid.dx, grid.nx}, material, load, shift,
                              observer);
}

}  // namespace contactd
