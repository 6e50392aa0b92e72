// A left wheel is a right one seen in a mirror: y and all that turns about x or z change their signs.
#pragma once

#include "contactd/contact_regions.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd {

WheelRailState mirrored(WheelRailState state);
WheelRailGeometry mirrored(WheelRailGeometry geometry);
/// A height is the same.
inline std::optional<double> mirrored(std::optional<double> z) {
    return z;
}
WheelRailSolution mirrored(WheelRailSolution solution);
/// Turns arrays over the elements of a patch, motion and rows; the signs of single numbers are those of their fields.
void mirror(ContactSolution& solution, const Grid& grid);
void mirror(Grid& grid);
void mirror(ContactPlace& place);
/// Keeps their order, by which elements in two of them belong to the first.
void mirror(ContactRegions& regions);

}  // namespace contactd
