// The way round line contacts of layered bodies.
#pragma once

namespace contactd {

/// The remedy in refusals of line_contact beside layers.
inline constexpr const char* row_of_layers =
    "goes with half-spaces, not with layers. Leave it out, and take one row of long elements: grid.ny 1, and grid.dy "
    "at least ten times the length of the contact, over which forces are counted";

}  // namespace contactd
