#include "contactd/closed_form_record.hpp"

#include <utility>

#include "contactd/fields/ic_spec.hpp"
#include "contactd/half_space.hpp"
#include "contactd/rotated_strips.hpp"
#include "contactd/strip_frames.hpp"
#include "contactd/version.hpp"
#include "influence/layered/layered_table.hpp"

namespace contactd {

IcRecord closed_form_record(const IcSpec& spec, const Observer& observer) {
    (void)strip_frames(spec);  // It refuses an invalid section in the lengths of the request.
    IcRecord record;
    record.spec = dimensionless(spec);
    const IcSpec& scaled = record.spec;
    if (scaled.section) {
        record.tables = rotated_strips(*scaled.section, {scaled.nx, scaled.ny, scaled.dx, scaled.dy}, scaled.material,
                                       scaled.load_shape, 0, "ics.section", observer);
    } else if (scaled.layered) {
        IcTable table =
            layered_table(*scaled.layered, scaled.load_shape, scaled.nx, scaled.ny, scaled.dx, scaled.dy, observer);
        record.evidence.errors = layered_errors(*scaled.layered, scaled.load_shape, table, scaled.dx, scaled.dy);
        record.evidence.errors_estimated = true;
        record.tables = std::move(table);
    } else {
        record.tables = half_space_table(scaled, observer);
    }
    record.evidence.source = name_of(IcSource::analytic);
    record.evidence.version = "contactd " + version();
    return record;
}

}  // namespace contactd
