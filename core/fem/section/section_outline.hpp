// Makes the outline of a section for meshing.
#pragma once

#include "geometry/section/section_geometry.hpp"
#include "outline.hpp"

namespace contactd::fem {

/// Requires a section whose lengths are divided by the width of a strip.
SectionOutline outline_of(const geometry::SectionGeometry& section);

}  // namespace contactd::fem
