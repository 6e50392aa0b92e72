#include "contactd/column_frames.hpp"

#include "geometry/section/section_geometry.hpp"

namespace contactd {

std::vector<ColumnFrame> column_frames(const Section& section, int columns, double ds, const std::string& field) {
    return geometry::SectionGeometry(section, columns, ds, field).frames();
}

}  // namespace contactd
