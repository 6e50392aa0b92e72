// Operators of contacts between wheel and rail that are curved across the track.
#pragma once

#include "contactd/contact_influence.hpp"
#include "contactd/ic_record.hpp"
#include "contactd/observer.hpp"
#include "contactd/patch_strips.hpp"

namespace contactd {

/// On strips that are not flat: of the tables of those sections that there are, or of half-spaces in closed form that
/// turn from row to row. Throws InvalidArgument ("dy") for tables of too many numbers, and Cancelled.
ContactInfluence patch_influence(const ContactProblem& problem, const PatchStrips& strips,
                                 const IcRecord* rail = nullptr, const IcRecord* wheel = nullptr,
                                 const Observer& observer = {});

}  // namespace contactd
