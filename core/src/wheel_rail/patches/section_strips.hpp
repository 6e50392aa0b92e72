// Selects the strips of the cross-sections of wheel and rail below the rows of a curved contact.
#pragma once

#include "contactd/patch_strips.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "geometry/position.hpp"

namespace contactd {

/// Returns the strips for the operators of a candidate patch, according to setup.conformal, which must not be
/// automatic. Strips lie at multiples of dy along a profile. Rows use the nearest strips, at most half an element away.
/// Throws InvalidArgument ("conformal") if a body has no strips below some of the rows.
PatchStrips strips_of(const WheelRailSetup& setup, const geometry::Profiles& profiles,
                      const geometry::CandidatePatch& found);

}  // namespace contactd
