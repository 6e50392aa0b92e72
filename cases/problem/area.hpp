// The potential contact area and the undeformed distance.
#pragma once

#include <optional>

#include "contactd/contact_regions.hpp"
#include "contactd/gap.hpp"
#include "contactd/grid.hpp"
#include "given/given.hpp"

namespace contactd::cases {

/// Hertz's contact, of which the elements are.
struct HertzResult {
    double a1 = 0, b1 = 0;  ///< curvatures (1/mm): h = a1 x^2 + b1 y^2
    SemiAxes axes;          ///< (mm); of a line contact half its length along y
    double scale = 0;
    double negative = 0, positive = 0;  ///< semi-axes across, towards -y and +y (mm)
};

struct Area {
    Grid grid;
    Gap gap;
    std::optional<HertzResult> hertz;       ///< where the elements follow from it
    std::optional<ContactRegions> regions;  ///< of a planform of patches
};

/// The grid of elements. That of a Hertz contact follows from the load, which must be set. Throws NotCovered, and
/// InvalidArgument of Hertz's formulas.
Grid grid_of(const Given& settings);
/// Throws NotCovered where the elements do not follow from a Hertz contact.
HertzResult hertz_of(const Given& settings);
/// Both, with the undeformed distance. A step goes on with the elements `before`, which is null of others.
Area area_of(const Given& settings, const Grid* before = nullptr);

}  // namespace contactd::cases
