// Converts ready-made sections to outlines.
#pragma once

#include <string>

#include "contactd/section.hpp"

namespace contactd::geometry {

/// Returns the outline of a section with its size and rotation, whose strips are together `width` wide along the
/// outline (mm). Throws InvalidArgument below `field` if a profile does not fit its section.
OutlineSection outline_of(const Section& section, double width, const std::string& field);

/// Return the outline of the shape alone, without scale and rotation.
OutlineSection outline_of(const RailSection& rail, double width);
OutlineSection outline_of(const WheelRimSection& rim, double width, const std::string& field);
OutlineSection outline_of(const ProfileSection& section, double width, const std::string& field);
OutlineSection outline_of(const EdgeBlock& block, double width);
OutlineSection outline_of(const Groove& groove, double width);
OutlineSection outline_of(const RoundEnd& end, double width);
OutlineSection outline_of(const Disc& disc, double width);
OutlineSection outline_of(const PlateHole& hole, double width);
OutlineSection outline_of(const Slab& slab, double width);

}  // namespace contactd::geometry
