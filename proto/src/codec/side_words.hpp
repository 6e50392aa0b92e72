// Which wheel of a wheelset.
#pragma once

#include "codec_parts.hpp"
#include "contactd/wheel_rail_setup.hpp"

namespace contactd::proto {

inline constexpr Words<Side, 2> side_words{{{"left", Side::left}, {"right", Side::right}}};

}  // namespace contactd::proto
