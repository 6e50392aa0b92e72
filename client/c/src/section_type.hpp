// Fields of the cross-section of a body by their paths.
#pragma once

#include "contactd/fields.hpp"

namespace contactd::c {

/// The fields of Section: "rail_60e1.inclination", "outline.outside.parts[0].line.to.y", "size". Setting a field of a
/// shape, or of a part's curve, selects it for the section or the part.
const FieldType& type_of_section();

}  // namespace contactd::c
