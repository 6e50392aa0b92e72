#include "contactd/closed_form_record.hpp"

#include "contactd/half_space.hpp"
#include "contactd/version.hpp"

namespace contactd {

IcRecord closed_form_record(const IcSpec& spec) {
    IcRecord record;
    record.spec = dimensionless(spec);
    record.tables = half_space_table(record.spec);
    record.evidence.source = name_of(IcSource::analytic);
    record.evidence.version = "contactd " + version();
    return record;
}

}  // namespace contactd
