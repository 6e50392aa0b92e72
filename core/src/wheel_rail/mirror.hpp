// Mirrors a left wheel to a right wheel and back: y and rotations about x or z change their signs.
#pragma once

#include "contactd/contact_regions.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

WheelRailState mirrored(WheelRailState state);
WheelRailGeometry mirrored(WheelRailGeometry geometry);
/// Returns the height unchanged.
inline std::optional<double> mirrored(std::optional<double> z) {
    return z;
}
WheelRailSolution mirrored(WheelRailSolution solution);
/// Mirrors arrays over the elements of a patch, motion and rows. The fields of single numbers define their signs.
void mirror(ContactSolution& solution, const Grid& grid);
void mirror(Grid& grid);
void mirror(ContactPlace& place);
/// Keeps the order of regions, because elements in two of them belong to the first.
void mirror(ContactRegions& regions);

}  // namespace contactd
