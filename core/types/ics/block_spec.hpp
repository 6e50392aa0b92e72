// Checks requirements of a block beyond those of any body.
#pragma once

#include "contactd/ic_spec.hpp"

namespace contactd {

/// Loads of all elements, about the middle of the block, must be on its top. Throws InvalidArgument ("ics.L_over_h")
/// otherwise.
void validate_room_on_block(const IcSpec& spec);

}  // namespace contactd
