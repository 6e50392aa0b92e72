#include "contactd/closed_form_record.hpp"

#include <utility>

#include "contactd/half_space.hpp"
#include "contactd/version.hpp"
#include "geometry/section/section_geometry.hpp"
#include "influence/layered/layered_table.hpp"
#include "influence/rotated/rotated_half_space.hpp"

namespace contactd {
namespace {

/// Of a prism: the half-space, turned from column to column.
ColumnTable rotated_table(const IcSpec& spec) {
    const geometry::SectionGeometry section(*spec.section, spec.ny, spec.dy, "ics.section");
    const std::vector<ColumnFrame> frames = section.frames();
    return rotated_half_space({frames, spec.dy, section.all_round() ? section.carrier().length() : 0, spec.dx, spec.nx},
                              spec.material, spec.load_shape);
}

}  // namespace

IcRecord closed_form_record(const IcSpec& spec, const Observer& observer) {
    IcRecord record;
    record.spec = dimensionless(spec);
    const IcSpec& scaled = record.spec;
    if (scaled.section) {
        record.tables = rotated_table(scaled);
    } else if (scaled.layered) {
        IcTable table =
            layered_table(*scaled.layered, scaled.load_shape, scaled.nx, scaled.ny, scaled.dx, scaled.dy, observer);
        record.evidence.errors = layered_errors(*scaled.layered, scaled.load_shape, table, scaled.dx, scaled.dy);
        record.evidence.errors_estimated = true;
        record.tables = std::move(table);
    } else {
        record.tables = half_space_table(scaled);
    }
    record.evidence.source = name_of(IcSource::analytic);
    record.evidence.version = "contactd " + version();
    return record;
}

std::vector<ColumnFrame> column_frames(const IcSpec& spec) {
    if (!spec.section) return {};
    return geometry::SectionGeometry(*spec.section, spec.ny, spec.dy, "ics.section").frames();
}

}  // namespace contactd
