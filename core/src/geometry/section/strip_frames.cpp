#include "contactd/strip_frames.hpp"

#include "geometry/section/section_geometry.hpp"

namespace contactd {

std::vector<StripFrame> strip_frames(const Section& section, int strips, double ds, const std::string& field) {
    return geometry::SectionGeometry(section, strips, ds, field).frames();
}

StripEnds strip_ends(const Section& section, int strips, double ds, const std::string& field) {
    const geometry::SectionGeometry geometry(section, strips, ds, field);
    return {geometry.is_edge(geometry.begin_of(0)), geometry.is_edge(geometry.begin_of(strips))};
}

}  // namespace contactd
