// Makes the potential contact area and the undeformed distance.
#pragma once

#include <optional>

#include "contactd/contact_regions.hpp"
#include "contactd/gap.hpp"
#include "contactd/grid.hpp"
#include "given/given.hpp"

namespace contactd::cases {

/// Holds the Hertzian contact that determines the elements.
struct HertzResult {
    double a1 = 0, b1 = 0;  ///< curvatures (1/mm): h = a1 x^2 + b1 y^2
    SemiAxes axes;          ///< (mm); for a line contact, b is half its length along y
    double scale = 0;
    double negative = 0, positive = 0;  ///< semi-axes along y, towards -y and +y (mm)
};

struct Area {
    Grid grid;
    Gap gap;
    std::optional<HertzResult> hertz;       ///< if it determines the elements
    std::optional<ContactRegions> regions;  ///< if the planform consists of patches
};

/// Returns the grid of elements. For a Hertzian contact it follows from the load, which must be given. Throws
/// NotCovered, and InvalidArgument from Hertz's formulas.
Grid grid_of(const Given& settings);
/// Returns the Hertzian contact. Throws NotCovered if the elements do not follow from one.
HertzResult hertz_of(const Given& settings);
/// Returns the grid with the undeformed distance. `before` is the grid of the last step if this step continues from it,
/// and null otherwise.
Area area_of(const Given& settings, const Grid* before = nullptr);

}  // namespace contactd::cases
