// From a section as a value to where its columns lie.
#pragma once

#include <string>
#include <vector>

#include "contactd/ic_spec.hpp"
#include "contactd/section.hpp"

namespace contactd {

/// Frames of the columns, each `ds` wide along the outline (mm): all that a contact needs to know of the geometry.
/// Takes a few milliseconds at most. Throws InvalidArgument below `field`, with coordinates, for all that is wrong with
/// the section or its columns: outlines that are open or cross, columns past a corner or on what is held, and more.
std::vector<ColumnFrame> column_frames(const Section& section, int columns, double ds,
                                       const std::string& field = "section");

/// Whether the body ends where its columns do: at a convex corner of the outline.
struct ColumnEnds {
    bool first = false, last = false;
};
/// Throws as column_frames() does.
ColumnEnds column_ends(const Section& section, int columns, double ds, const std::string& field = "section");

/// Those that a request's table has: of a prism, and none of other bodies.
inline std::vector<ColumnFrame> column_frames(const IcSpec& spec) {
    return spec.section ? column_frames(*spec.section, spec.ny, spec.dy, "ics.section") : std::vector<ColumnFrame>();
}

}  // namespace contactd
