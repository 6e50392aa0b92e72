#include <catch2/catch_test_macros.hpp>

#include "contactd/closed_form_record.hpp"
#include "contactd/half_space.hpp"
#include "contactd/version.hpp"

using namespace contactd;

TEST_CASE("A closed form's record is dimensionless, and names its source and version", "[closed form]") {
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = 0.8;
    spec.dy = 0.4;
    spec.nx = 3;
    spec.ny = 2;

    const IcRecord record = closed_form_record(spec);

    CHECK(record.spec == dimensionless(spec));
    CHECK(record.table().values == half_space_table(dimensionless(spec)).values);
    CHECK(record.evidence.source == "analytic");
    CHECK(record.evidence.version == "contactd " + version());
    CHECK(std::holds_alternative<IcTable>(record.tables));
}
