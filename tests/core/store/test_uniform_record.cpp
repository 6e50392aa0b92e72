#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contactd/error.hpp"
#include "ic_records.hpp"
#include "store/hdf5/section_numbers.hpp"

using namespace contactd;
using Catch::Matchers::WithinRel;

namespace {

IcSpec uniform_spec(double scale) {
    IcSpec spec = fem_spec(30, 4);
    spec.body = BodyShape::longitudinally_uniform;
    spec.accuracy = 1e-3;
    spec.dx = 0.25 * scale;
    spec.dy = 0.5 * scale;
    spec.section = Section{EdgeBlock{100 * scale, 50 * scale, 1 * scale}};
    return spec;
}

IcRecord uniform_record() {
    IcRecord record{dimensionless(uniform_spec(1)), {}, {}};
    StripSpectrum spectrum{4, 0.28, 0.01, {0, 0.1, 0.5, 2, 6}, {}, {}};
    for (int strip = 0; strip < 4; ++strip) spectrum.frames.push_back({strip - 5.5, 0, 0.01 * strip});
    for (std::size_t n = 0; n < spectrum.nodes.size() * spectrum.component_size(); ++n)
        spectrum.values.push_back(std::cos(0.1 * static_cast<double>(n)));
    record.tables = spectrum;
    record.evidence.source = "fem";
    record.evidence.section = SectionEvidence{4, 21, 6e-4, 3e-4, 2e-4, 1e-4, 5e-4};
    return record;
}

std::string key_with(const auto& change) {
    IcSpec spec = uniform_spec(1);
    change(spec);
    return ic_key(spec);
}

}  // namespace

TEST_CASE("A uniform body's key is that of its shape, whatever its size, its material's G and its elements along x") {
    const std::string key = ic_key(uniform_spec(1));
    CHECK(ic_key(uniform_spec(3)) == key);
    CHECK(key_with([](IcSpec& spec) { spec.dx = 0.7; }) == key);
    CHECK(key_with([](IcSpec& spec) { spec.nx = 7; }) == key);
    CHECK(key_with([](IcSpec& spec) { spec.material.G = 1; }) == key);
    CHECK(key_with([](IcSpec& spec) { spec.ny = 5; }) != key);
    CHECK(key_with([](IcSpec& spec) { spec.material.nu = 0.3; }) != key);
    CHECK(key_with([](IcSpec& spec) { spec.accuracy = 1e-2; }) != key);
    CHECK(key_with([](IcSpec& spec) { std::get<EdgeBlock>(spec.section->shape).height = 51; }) != key);
    CHECK(key_with([](IcSpec& spec) { spec.section->turn = 0.1; }) != key);
    CHECK(key_with([](IcSpec& spec) { spec.section = Section{Groove{100, 50, 1, 0}}; }) != key);
}

TEST_CASE("A uniform body's record goes through a file as it is, and serves any number of offsets") {
    const TemporaryFolder folder;
    const IcStore store(folder.path(), [](const std::string&) {});
    const IcRecord record = uniform_record();
    const auto [nx, ny] = extent_of(record.tables);
    write_ic_file(store.path_of(ic_key(record.spec), nx, ny), record);
    const auto found = store.find(uniform_spec(3));
    REQUIRE(found);
    CHECK(found->spec == record.spec);
    CHECK(std::get<StripSpectrum>(found->tables) == std::get<StripSpectrum>(record.tables));
    CHECK(found->evidence.section == record.evidence.section);
}

TEST_CASE("A longitudinally uniform body's table has its units, and a row for each pair of strips") {
    const IcRecord record = uniform_record();
    const IcSpec spec = uniform_spec(3);
    const auto strips = std::get<StripTable>(body_table(record, spec));
    const StripTable plain = strip_table(std::get<StripSpectrum>(record.tables), 0.5, 30);
    CHECK_THAT(strips(Axis::z, Axis::z, 1, 2, 3), WithinRel(plain(Axis::z, Axis::z, 1, 2, 3) * 1.5 / 82000, 1e-12));
    const IcTable rows = table_for(record, spec);
    CHECK(rows.nx == 30);
    CHECK(rows.ny == table_rows(spec));
    CHECK(rows(Axis::x, Axis::z, 3, 1 * 4 + 2) == strips(Axis::x, Axis::z, 1, 2, 3));
    IcSpec wider = spec;
    wider.ny = 5;
    CHECK_THROWS_AS(body_table(record, wider), InvalidArgument);
}

TEST_CASE("Numbers of a section say all of it, and others are refused") {
    const Outline outline{{-5, 0},
                          {{LineTo{{5, 0}}, false}, {SplineTo{{{6, -1}, {5, -5}}}, true}, {ArcTo{{-5, 0}, 9}, true}}};
    for (const Section& section :
         {Section{OutlineSection{outline, {outline}, 1, 2, 0.3}, 2, 0.1, true},
          Section{RailSection{0.025, RailSupport::foot, 2}},
          Section{ProfileSection{{ProfileKind::rail, StandardProfile{StandardName::n60E2, 0.05}}, 60, 1}},
          Section{ProfileSection{{ProfileKind::rail, ProfilePoints{{{1, 2}, {3, 4}}, 1000, true, false, 2}}, 60, 1}}})
        CHECK(section_from(numbers_of(section)) == section);
    std::vector<double> numbers = numbers_of(Section{Slab{1, 2}});
    numbers.pop_back();
    CHECK_THROWS_AS(section_from(numbers), DamagedTable);
    numbers = {99, 1, 0, 0};
    CHECK_THROWS_AS(section_from(numbers), DamagedTable);
    CHECK_THROWS_AS(section_from({0, 1e300}), DamagedTable);
    CHECK_THROWS_AS(section_from({std::nan("")}), DamagedTable);
}
