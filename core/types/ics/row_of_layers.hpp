// Describes the alternative to line contacts of layered bodies.
#pragma once

namespace contactd {

/// Refusals of line_contact with layers contain this remedy.
inline constexpr const char* row_of_layers =
    "is available for half-spaces, not for layers. Remove it, and use one row of long elements, with grid.ny = 1 and "
    "grid.dy at least ten times the length of the contact; forces refer to the length grid.dy";

}  // namespace contactd
