// Which strips of wheel and rail, by their cross-sections, lie under the rows of a curved contact.
#pragma once

#include "contactd/patch_strips.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// Returns the strips of a candidate patch, of which its operators are made, by setup.conformal, which is not
/// automatic. Strips lie at multiples of dy along a profile, and rows on the nearest ones: off by half an element at
/// most. Throws InvalidArgument ("conformal") where a body has no strips below all rows.
PatchStrips strips_of(const WheelRailSetup& setup, const geometry::Profiles& profiles,
                      const geometry::CandidatePatch& found);

}  // namespace contactd
