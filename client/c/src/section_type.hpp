// The cross-section of a body as its paths name it.
#pragma once

#include "contactd/fields.hpp"

namespace contactd::c {

/// The fields of Section: "rail_60e1.inclination", "outline.outside.parts[0].line.to.y", "size". Naming a field of a
/// shape, or of a part's curve, makes the section or the part one of that.
const FieldType& type_of_section();

}  // namespace contactd::c
