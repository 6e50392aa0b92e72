#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <functional>

#include "contactd/column_frames.hpp"
#include "contactd/error.hpp"
#include "contactd/ic_exchange.hpp"
#include "contactd/stored_record.hpp"
#include "ic_records.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinRel;

namespace {

/// As a daemon exports it: with dimensions, and what the builder has made for G = 1 and columns of width 1.
IcRecord exported_prism() {
    IcSpec spec = fem_spec(3, 4);
    spec.body = BodyShape::prism;
    spec.accuracy = 1e-3;
    spec.material.G = 82000;
    spec.dx = 0.25;
    spec.dy = 0.5;
    spec.section = Section{Groove{5, 5, 60, 40}};
    IcRecord record{spec, {}, {}};
    ColumnSpectrum spectrum{4, spec.material.nu, 0.01, {0, 0.1, 0.5, 2, 6}, {}, {}};
    spectrum.frames = column_frames(*dimensionless(spec).section, 4, 1);
    for (std::size_t n = 0; n < spectrum.nodes.size() * spectrum.component_size(); ++n)
        spectrum.values.push_back(2 + std::cos(0.1 * static_cast<double>(n)));
    record.tables = spectrum;
    record.evidence.source = "fem";
    record.evidence.section = SectionEvidence{4, 21, 6e-4, 3e-4, 2e-4, 1e-4, 5e-4};
    return record;
}

IcRecord exported_half_space() {
    const IcSpec spec = fem_spec(2, 2);
    IcRecord record{spec, IcTable(2, 2), {}};
    record.spec.material.G = 82000;
    record.spec.dx = record.spec.dy = 0.5;
    for (const Axis i : {Axis::x, Axis::y, Axis::z})
        for (int l = 0; l < 2; ++l)
            for (int k = 0; k < 2; ++k) record.table()(i, i, k, l) = 1e-6 / (1 + k + l);
    record.evidence.source = "fem";
    return record;
}

IcRecord through_a_file(const IcRecord& record) {
    return from_ic_file(to_ic_file(record), "the file");
}

/// What is said of the record when `change` was made to it.
std::string refusal_of(IcRecord record, const std::function<void(IcRecord&)>& change) {
    change(record);
    try {
        (void)stored_record(std::move(record));
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "file");
        return error.what();
    }
    return "taken";
}

}  // namespace

TEST_CASE("An exported prism comes back as the record that was built, with its key", "[exchange]") {
    const IcRecord exported = exported_prism();
    const IcRecord back = stored_record(through_a_file(exported));
    CHECK(ic_key(back.spec) == ic_key(exported.spec));
    CHECK(back.spec == dimensionless(exported.spec));
    CHECK(std::get<ColumnSpectrum>(back.tables) == std::get<ColumnSpectrum>(exported.tables));
    CHECK(back.evidence.section == exported.evidence.section);
    IcSpec longer = exported.spec;
    longer.nx = 9;
    longer.dx = 0.6;
    CHECK(table_for(back, longer) == table_for(exported, longer));
}

TEST_CASE("A prism that is told in units is no file of a store by itself", "[exchange]") {
    const TemporaryFolder folder;
    const IcStore store(folder.path(), [](const std::string&) {});
    const IcRecord exported = exported_prism();
    const auto [nx, ny] = extent_of(exported.tables);
    write_ic_file(store.path_of(ic_key(exported.spec), nx, ny), exported);
    CHECK_FALSE(store.find(exported.spec));
}

TEST_CASE("An exported table comes back dimensionless", "[exchange]") {
    const IcRecord exported = exported_half_space();
    const IcRecord back = stored_record(through_a_file(exported));
    CHECK(back.spec == dimensionless(exported.spec));
    CHECK_THAT(back.table()(Axis::z, Axis::z, 1, 0), WithinRel(0.5e-6 * 82000 / 0.5, 1e-15));
}

TEST_CASE("A store's own record comes back as it is", "[exchange]") {
    IcRecord prism = exported_prism();
    prism.spec = dimensionless(prism.spec);
    CHECK(std::get<ColumnSpectrum>(stored_record(through_a_file(prism)).tables) ==
          std::get<ColumnSpectrum>(prism.tables));
}

TEST_CASE("What no builder makes is refused with a sentence", "[exchange]") {
    const auto spectrum = [](IcRecord& record) -> ColumnSpectrum& { return std::get<ColumnSpectrum>(record.tables); };
    CHECK_THAT(refusal_of(exported_half_space(), [](IcRecord& record) { record.spec.source = IcSource::analytic; }),
               ContainsSubstring("analytic"));
    CHECK_THAT(refusal_of(exported_half_space(), [](IcRecord& record) { record.spec.material.nu = 0.7; }),
               ContainsSubstring("material.nu"));
    CHECK_THAT(refusal_of(exported_half_space(),
                          [](IcRecord& record) { record.table()(Axis::z, Axis::z, 0, 0) = std::nan(""); }),
               ContainsSubstring("zz"));
    CHECK_THAT(refusal_of(exported_half_space(), [](IcRecord& record) { record.table()(Axis::x, Axis::x, 0, 0) = -1; }),
               ContainsSubstring("xx"));
    CHECK_THAT(refusal_of(exported_prism(), [&](IcRecord& record) { spectrum(record).frames[2].y += 0.1; }),
               ContainsSubstring("frames"));
    CHECK_THAT(refusal_of(exported_prism(), [&](IcRecord& record) { spectrum(record).values[0] = -1; }),
               ContainsSubstring("yields against its load"));
    CHECK_THAT(
        refusal_of(exported_prism(), [](IcRecord& record) { std::get<Groove>(record.spec.section->shape).depth = 6; }),
        ContainsSubstring("groove.depth"));
    CHECK(refusal_of(exported_prism(), [](IcRecord&) {}) == "taken");
}
