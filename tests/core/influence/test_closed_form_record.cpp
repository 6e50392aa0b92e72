#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <string>

#include "contactd/closed_form_record.hpp"
#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "contactd/strip_frames.hpp"
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

TEST_CASE("A section that its strips leave is refused in the lengths of the request", "[closed form]") {
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.body = BodyShape::longitudinally_uniform;
    spec.section = Section{EdgeBlock{.width = 100, .height = 60, .edge_distance = 50}};
    spec.dx = spec.dy = GENERATE(0.5, 2.0);
    spec.nx = 2;
    spec.ny = 1000;
    const auto refusal = [&](const auto& work) -> std::string {
        try {
            work();
        } catch (const InvalidArgument& error) {
            return error.problem();
        }
        return "none";
    };
    CHECK(refusal([&] { closed_form_record(spec); }) == refusal([&] { strip_frames(spec); }));
    CHECK(refusal([&] { closed_form_record(spec); }) != "none");
}
