// From a section as a value to where its strips lie.
#pragma once

#include <string>
#include <vector>

#include "contactd/ic_spec.hpp"
#include "contactd/section.hpp"

namespace contactd {

/// Frames of the strips, each `ds` wide along the outline (mm): all that a contact needs to know of the geometry.
/// Takes a few milliseconds at most. Throws InvalidArgument below `field`, with coordinates, for all that is wrong with
/// the section or its strips: outlines that are open or cross, strips past a corner or on what is clamped, and more.
std::vector<StripFrame> strip_frames(const Section& section, int strips, double ds,
                                     const std::string& field = "section");

/// Whether the body ends where its strips do: at a convex corner of the outline.
struct StripEnds {
    bool first = false, last = false;
};
/// Throws as strip_frames() does.
StripEnds strip_ends(const Section& section, int strips, double ds, const std::string& field = "section");

/// Those that a request's table has: of a longitudinally uniform body, and none of other bodies.
inline std::vector<StripFrame> strip_frames(const IcSpec& spec) {
    return spec.section ? strip_frames(*spec.section, spec.ny, spec.dy, "ics.section") : std::vector<StripFrame>();
}

}  // namespace contactd
