#include "contactd/column_frames.hpp"

#include "geometry/section/section_geometry.hpp"

namespace contactd {

std::vector<ColumnFrame> column_frames(const Section& section, int columns, double ds, const std::string& field) {
    return geometry::SectionGeometry(section, columns, ds, field).frames();
}

ColumnEnds column_ends(const Section& section, int columns, double ds, const std::string& field) {
    const geometry::SectionGeometry geometry(section, columns, ds, field);
    return {geometry.is_edge(geometry.begin_of(0)), geometry.is_edge(geometry.begin_of(columns))};
}

}  // namespace contactd
