#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <functional>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "contactd/ic_exchange.hpp"
#include "contactd/ic_family.hpp"
#include "contactd/stored_record.hpp"
#include "contactd/strip_frames.hpp"
#include "ic_records.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinRel;

namespace {

/// Returns a record as a daemon exports it: with dimensions, and the builder's results for G = 1 and strips of width 1.
IcRecord exported_uniform() {
    IcSpec spec = fem_spec(3, 4);
    spec.body = BodyShape::longitudinally_uniform;
    spec.accuracy = 1e-3;
    spec.material.G = 82000;
    spec.dx = 0.25;
    spec.dy = 0.5;
    spec.section = Section{Groove{5, 5, 60, 40}};
    IcRecord record{spec, {}, {}};
    StripSpectrum spectrum{4, spec.material.nu, 0.01, {0, 0.1, 0.5, 2, 6}, {}, {}};
    spectrum.frames = strip_frames(*dimensionless(spec).section, 4, 1);
    spectrum.values.assign(spectrum.nodes.size() * spectrum.component_size(), 0);
    for (std::size_t node = 0; node < spectrum.nodes.size(); ++node)
        for (int a = 0; a < 12; ++a)
            for (int b = 0; b <= a; ++b)
                spectrum.values[spectrum.index(node, a, b)] = (a == b ? 2 : 0) + std::cos(0.1 * (a - b));
    record.tables = spectrum;
    record.evidence.source = "fem";
    record.evidence.section = SectionEvidence{4, 21, 6e-4, 3e-4, 2e-4, 1e-4, 5e-4};
    return record;
}

IcSpec steel(int nx, int ny) {
    IcSpec spec = fem_spec(nx, ny);
    spec.material = {82000, 0.28};
    spec.dx = 0.5;
    spec.dy = 0.4;
    return spec;
}

IcTable closed_form(IcSpec spec) {
    spec.source = IcSource::analytic;
    spec.body = BodyShape::half_space;
    spec.accuracy = 0;
    return half_space_table(spec);
}

/// Returns the closed form as if computed by finite elements with an error of 1e-3, including its evidence.
IcRecord exported_half_space(int nx = 9, int ny = 7) {
    const IcSpec spec = steel(nx, ny);
    IcRecord record{spec, scaled(closed_form(spec), 1.001), {}};
    compare_with_half_space(spec, record.table(), record.evidence);
    record.evidence.source = "fem";
    return record;
}

/// Returns a block that differs from the half-space by a constant, like large blocks.
IcRecord exported_block() {
    IcSpec spec = steel(6, 6);
    spec.body = BodyShape::block;
    spec.accuracy = 1e-2;
    spec.fem.L_over_h = 20;
    IcRecord record{spec, closed_form(spec), {}};
    for (const Axis i : {Axis::x, Axis::y, Axis::z}) {
        const double difference = 0.03 * record.table()(i, i, 0, 0);
        for (int l = 0; l < 6; ++l)
            for (int k = 0; k < 6; ++k) record.table()(i, i, k, l) -= difference;
    }
    record.evidence.source = "fem";
    return record;
}

IcRecord through_a_file(const IcRecord& record) {
    return from_ic_file(to_ic_file(record), "the file");
}

IcRecord stored(IcRecord record) {
    return stored_record(std::move(record), Observer());
}

/// Returns the refusal of the record after `change`.
std::string refusal_of(IcRecord record, const std::function<void(IcRecord&)>& change) {
    change(record);
    try {
        (void)stored(std::move(record));
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "datasets");
        return error.what();
    }
    return "taken";
}

}  // namespace

TEST_CASE("An exported uniform body comes back as the record that was built, with its key", "[exchange]") {
    const IcRecord exported = exported_uniform();
    const IcRecord back = stored(through_a_file(exported));
    CHECK(ic_key(back.spec) == ic_key(exported.spec));
    CHECK(back.spec == dimensionless(exported.spec));
    CHECK(std::get<StripSpectrum>(back.tables) == std::get<StripSpectrum>(exported.tables));
    CHECK(back.evidence.section == exported.evidence.section);
    IcSpec longer = exported.spec;
    longer.nx = 9;
    longer.dx = 0.6;
    CHECK(table_for(back, longer) == table_for(exported, longer));
}

TEST_CASE("A uniform body that is told in units is no file of a store by itself", "[exchange]") {
    const TemporaryFolder folder;
    const IcStore store(folder.path(), [](const std::string&) {});
    const IcRecord exported = exported_uniform();
    const auto [nx, ny] = extent_of(exported.tables);
    write_ic_file(store.path_of(ic_key(exported.spec), nx, ny), exported);
    CHECK_FALSE(store.find(exported.spec));
}

TEST_CASE("An exported table comes back dimensionless", "[exchange]") {
    const IcRecord exported = exported_half_space();
    const IcRecord back = stored(through_a_file(exported));
    CHECK(back.spec == dimensionless(exported.spec));
    CHECK_THAT(back.table()(Axis::z, Axis::z, 1, 0),
               WithinRel(exported.table()(Axis::z, Axis::z, 1, 0) * 82000 / 0.5, 1e-15));
}

TEST_CASE("A store's own record comes back as it is", "[exchange]") {
    IcRecord uniform = exported_uniform();
    uniform.spec = dimensionless(uniform.spec);
    CHECK(std::get<StripSpectrum>(stored(through_a_file(uniform)).tables) == std::get<StripSpectrum>(uniform.tables));
}

TEST_CASE("What no builder makes is refused with a sentence", "[exchange]") {
    const auto spectrum = [](IcRecord& record) -> StripSpectrum& { return std::get<StripSpectrum>(record.tables); };
    CHECK_THAT(refusal_of(exported_half_space(), [](IcRecord& record) { record.spec.source = IcSource::analytic; }),
               ContainsSubstring("analytic"));
    CHECK_THAT(refusal_of(exported_half_space(), [](IcRecord& record) { record.spec.material.nu = 0.7; }),
               ContainsSubstring("material.nu"));
    CHECK_THAT(refusal_of(exported_half_space(),
                          [](IcRecord& record) { record.table()(Axis::z, Axis::z, 0, 0) = std::nan(""); }),
               ContainsSubstring("zz"));
    CHECK_THAT(refusal_of(exported_half_space(), [](IcRecord& record) { record.table()(Axis::x, Axis::x, 0, 0) = -1; }),
               ContainsSubstring("xx"));
    CHECK_THAT(refusal_of(exported_uniform(), [&](IcRecord& record) { spectrum(record).frames[2].y += 0.1; }),
               ContainsSubstring("frames"));
    CHECK_THAT(refusal_of(exported_uniform(), [&](IcRecord& record) { spectrum(record).values[0] = -1; }),
               ContainsSubstring("moves a strip against its load"));
    CHECK_THAT(refusal_of(exported_uniform(),
                          [](IcRecord& record) { std::get<Groove>(record.spec.section->shape).depth = 6; }),
               ContainsSubstring("groove.depth"));
    for (const IcRecord& good :
         {exported_uniform(), exported_half_space(), exported_block(), exported_half_space(1, 1)})
        CHECK(refusal_of(good, [](IcRecord&) {}) == "taken");
}

TEST_CASE("A table of a half-space that errs by more than it states is refused", "[exchange]") {
    const auto says = ContainsSubstring("relative to the closed form");
    CHECK_THAT(refusal_of(exported_half_space(), [](IcRecord& record) { record.tables = scaled(record.table(), 1.5); }),
               says);
    CHECK_THAT(refusal_of(exported_half_space(), [](IcRecord& record) { record.spec.accuracy = 1e-4; }), says);
    CHECK_THAT(
        refusal_of(exported_half_space(), [](IcRecord& record) { record.table()(Axis::x, Axis::z, 3, 2) *= 1.1; }),
        says);
    CHECK_THAT(refusal_of(exported_half_space(), [](IcRecord& record) { record.evidence.errors = {}; }),
               ContainsSubstring("lack their errors"));
}

TEST_CASE("A family is held against the closed form at each of its Poisson's ratios", "[exchange]") {
    IcRecord record = exported_half_space();
    record.spec.any_nu = true;
    record.spec.material = {1, 0};
    record.spec.dx = 1;
    record.spec.dy = 0.8;
    record.spec.accuracy = 1e-2;
    record.evidence.family_nu = family_points(2);
    IcFamily family;
    for (const double nu : record.evidence.family_nu) {
        IcSpec spec = record.spec;
        spec.any_nu = false;
        spec.material.nu = nu;
        family.tables.push_back(scaled(closed_form(spec), 1.0005));
    }
    record.tables = family;
    record.evidence.interpolation_error = 1e-4;
    const auto of_family = [](IcRecord& given) -> IcFamily& { return std::get<IcFamily>(given.tables); };

    CHECK(refusal_of(record, [](IcRecord&) {}) == "taken");
    CHECK_THAT(
        refusal_of(record, [&](IcRecord& given) { std::swap(of_family(given).tables[0], of_family(given).tables[3]); }),
        ContainsSubstring("relative to the closed form"));
    CHECK_THAT(refusal_of(record, [](IcRecord& given) { given.evidence.family_nu[1] += 0.01; }),
               ContainsSubstring("other Poisson's ratios"));
}

TEST_CASE("A block that is no block is refused", "[exchange]") {
    CHECK_THAT(refusal_of(exported_block(), [](IcRecord& record) { record.tables = scaled(record.table(), 1.5); }),
               ContainsSubstring("a block of this size cannot differ"));
    CHECK_THAT(refusal_of(exported_block(), [](IcRecord& record) { record.table()(Axis::z, Axis::z, 1, 1) *= -3; }),
               ContainsSubstring("a block of this size cannot differ"));
    CHECK_THAT(refusal_of(exported_block(),
                          [](IcRecord& record) {
                              for (int l = 0; l < 6; ++l)
                                  for (int k = 0; k < 6; ++k) record.table()(Axis::x, Axis::z, k, l) *= -1;
                          }),
               ContainsSubstring("not reciprocal"));
}

TEST_CASE("Coefficients under which a traction takes work out of the body are refused", "[exchange]") {
    // Each is similar to a half-space's, and largest at its origin; together they have negative energy for alternating
    // loads.
    const auto alternating = [](IcRecord& record) {
        IcTable& table = record.table();
        const double change = 0.1 * table(Axis::z, Axis::z, 0, 0);
        for (int l = 0; l < 6; ++l)
            for (int k = 0; k < 6; ++k)
                if (k + l > 0) table(Axis::z, Axis::z, k, l) -= (k + l) % 2 == 0 ? change : -change;
    };
    CHECK_THAT(refusal_of(exported_block(), alternating), ContainsSubstring("a negative elastic energy"));
    CHECK_THAT(refusal_of(exported_uniform(),
                          [](IcRecord& record) {
                              auto& spectrum = std::get<StripSpectrum>(record.tables);
                              spectrum.values[spectrum.index(3, 7, 4)] = 4;
                          }),
               ContainsSubstring("a negative elastic energy"));
}
