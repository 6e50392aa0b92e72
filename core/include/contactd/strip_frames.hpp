// Computes the positions of the strips of a section.
#pragma once

#include <string>
#include <vector>

#include "contactd/ic_spec.hpp"
#include "contactd/section.hpp"

namespace contactd {

/// Returns the frames of the strips, each `ds` wide along the outline (mm), which are the geometry of a contact. Takes
/// at most a few milliseconds. Throws InvalidArgument below `field`, with coordinates, for errors of the section or its
/// strips, such as outlines that are open or cross, and strips beyond a corner or on a clamped part.
std::vector<StripFrame> strip_frames(const Section& section, int strips, double ds,
                                     const std::string& field = "section");

/// Holds whether the body ends with its first and last strip, at a convex corner of the outline.
struct StripEnds {
    bool first = false, last = false;
};
/// Returns at which strips the body ends. Throws as strip_frames() does.
StripEnds strip_ends(const Section& section, int strips, double ds, const std::string& field = "section");

/// Returns the frames of a request's table: those of a longitudinally uniform body, and none for other bodies.
inline std::vector<StripFrame> strip_frames(const IcSpec& spec) {
    return spec.section ? strip_frames(*spec.section, spec.ny, spec.dy, "ics.section") : std::vector<StripFrame>();
}

}  // namespace contactd
