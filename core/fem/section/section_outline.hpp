// The outline of a section as meshes are made from it.
#pragma once

#include "geometry/section/section_geometry.hpp"
#include "outline.hpp"

namespace contactd::fem {

/// Takes a section whose lengths are over the width of a strip.
SectionOutline outline_of(const geometry::SectionGeometry& section);

}  // namespace contactd::fem
