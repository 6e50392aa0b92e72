#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include "contactd/ic_contents.hpp"
#include "ic_records.hpp"

using namespace contactd;

namespace {

/// Creates a family of `size` tables with its evidence.
IcRecord family_of(IcSpec spec, int size) {
    spec.any_nu = true;
    spec.accuracy = 1e-3;
    IcRecord record = record_of(spec);
    IcFamily family;
    for (int n = 0; n < size; ++n) {
        record.evidence.family_nu.push_back(0.49 * n / (size - 1));
        family.tables.push_back(scaled(record.table(), 1 + n));
    }
    record.tables = std::move(family);
    record.evidence.interpolation_error = 3e-6;
    record.evidence.modelling_error = 0.07;
    record.evidence.errors_estimated = true;
    record.evidence.mesh = FemSpec{};
    record.evidence.mesh->order = 4;
    record.evidence.mesh->strength_threshold = 0.7;
    return record;
}

/// Creates a spec whose every field differs from its default.
IcSpec unusual_spec() {
    IcSpec spec = fem_spec(4, 3);
    spec.dy = 0.5;
    spec.body = BodyShape::block;
    spec.load_shape = LoadShape::bilinear;
    FemSpec& fem = spec.fem;
    fem.mesh = MeshKind::prism;
    fem.order = 5;
    fem.l_over_h = 1.5;
    fem.h_over_hs = 6;
    fem.f = 1.4;
    fem.t1_over_hs = 0.7;
    fem.L_over_h = 33;
    fem.diagonal = Diagonal::across;
    fem.far_boundary = FarBoundary::clamped;
    fem.sampling = Sampling::linear_nodes;
    fem.solver = Solver::amg_pcg;
    fem.stopping_criterion = StoppingCriterion::update;
    fem.tolerance = 1e-7;
    fem.max_iterations = 17;
    fem.strength_threshold = 0.25;
    return spec;
}

}  // namespace

TEST_CASE("A file keeps what a part of the coefficients says") {
    const TemporaryFolder folder;
    IcSpec spec = fem_spec(5, 1);
    spec.source = IcSource::analytic;
    spec.line_contact = LineContactSpec{20};

    write_ic_file(folder.path() / "table.h5", record_of(spec));
    const IcRecord read = read_ic_file(folder.path() / "table.h5");

    REQUIRE(read.spec.line_contact.has_value());
    CHECK(read.spec.line_contact->datum == 25);  // in units of dx
}

TEST_CASE("A written table reads back as it was") {
    const TemporaryFolder folder;
    const IcRecord written = record_of(fem_spec(5, 3));

    write_ic_file(folder.path() / "table.h5", written);
    const IcRecord read = read_ic_file(folder.path() / "table.h5");

    CHECK(read.spec == written.spec);
    CHECK(read.table().nx == 5);
    CHECK(read.table().ny == 3);
    CHECK(read.table().values == written.table().values);
    CHECK(read.evidence.elements == 1840);
    REQUIRE(read.evidence.load_cases.size() == 2);
    CHECK(read.evidence.load_cases[1].load == Axis::x);
    CHECK(read.evidence.load_cases[1].iterations == 12);
    CHECK(read.evidence.errors.zz->origin == -1.2e-3);
    CHECK_FALSE(read.evidence.errors.xx.has_value());
    CHECK(read.evidence.errors.scaled_xz == 2e-4);
    CHECK(read.evidence.solver == "direct");
    CHECK(read.evidence.warnings == written.evidence.warnings);
    CHECK_FALSE(read.evidence.load_cases[0].update.has_value());
    CHECK(read.evidence.load_cases[1].update == 7e-10);
    CHECK_FALSE(read.evidence.errors_estimated);
    CHECK_FALSE(read.evidence.mesh.has_value());
    CHECK(read.evidence.family_nu.empty());
    CHECK(std::holds_alternative<IcTable>(read.tables));
    CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("Every kind of spec reads back as it was") {
    const TemporaryFolder folder;
    IcSpec spec = unusual_spec();
    SECTION("every field of a mesh") {}
    SECTION("a threshold chosen for the mesh") {
        spec.fem.strength_threshold.reset();
    }
    SECTION("an adaptive mesh") {
        spec.fem.mesh = MeshKind::adaptive;
        spec.fem.max_dofs = 123'456;
    }
    SECTION("an accuracy") {
        spec.accuracy = 1e-4;
    }
    SECTION("an accuracy of the half-space") {
        spec.accuracy = 1e-2;
        spec.body = BodyShape::half_space;
    }
    SECTION("closed form") {
        spec.source = IcSource::analytic;
        spec.body = BodyShape::half_space;
    }
    const IcRecord written = record_of(spec);
    write_ic_file(folder.path() / "table.h5", written);

    CHECK(read_ic_file(folder.path() / "table.h5").spec == written.spec);
}

TEST_CASE("A family reads back with all its tables") {
    const TemporaryFolder folder;
    const IcRecord written = family_of(fem_spec(5, 3), 4);

    write_ic_file(folder.path() / "family.h5", written);
    const IcRecord read = read_ic_file(folder.path() / "family.h5");

    CHECK(read.spec == written.spec);
    CHECK(read.evidence.family_nu == written.evidence.family_nu);
    CHECK(read.evidence.interpolation_error == 3e-6);
    CHECK(read.evidence.modelling_error == 0.07);
    CHECK(read.evidence.errors_estimated);
    CHECK(read.evidence.mesh == written.evidence.mesh);
    const auto& tables = std::get<IcFamily>(read.tables).tables;
    REQUIRE(tables.size() == 4);
    CHECK(tables[0].nx == 5);
    CHECK(tables[0].ny == 3);
    CHECK(tables == std::get<IcFamily>(written.tables).tables);
}

TEST_CASE("A family that does not hold together is damaged") {
    const TemporaryFolder folder;
    IcRecord record = family_of(fem_spec(5, 3), 4);
    SECTION("without its tables") {
        record.tables = IcTable(5, 3);
    }
    SECTION("of one table") {
        record = family_of(fem_spec(5, 3), 2);
        std::get<IcFamily>(record.tables).tables.pop_back();
        record.evidence.family_nu.pop_back();
    }
    SECTION("with more Poisson's ratios than tables") {
        record.evidence.family_nu.push_back(0.495);
    }
    write_ic_file(folder.path() / "family.h5", record);

    CHECK_THROWS_AS(read_ic_file(folder.path() / "family.h5"), DamagedTable);
}

TEST_CASE("A file that names a field or its keyword otherwise is damaged, and says which") {
    FileContents contents = contents_of(record_of(fem_spec(5, 1)));
    std::string message;
    SECTION("a keyword") {
        contents.attributes.at("spec/body") = std::string("prism");
        message = "spec/body of the file is not supported.";
    }
    SECTION("a field") {
        auto field = contents.attributes.extract("spec/stopping_criterion");
        REQUIRE_FALSE(field.empty());
        field.key() = "spec/stop_test";
        contents.attributes.insert(std::move(field));
        message = "spec/stopping_criterion of the file is missing.";
    }
    CHECK_THROWS_MATCHES(record_from(contents), DamagedTable, Catch::Matchers::Message(message));
}

TEST_CASE("Writing where nothing can be written is an error that names the file") {
    CHECK_THROWS_AS(write_ic_file("/proc/no-such-folder/table.h5", record_of(fem_spec(2, 2))), StoreError);
    CHECK_THROWS_AS(read_ic_file("/proc/no-such-folder/table.h5"), StoreError);
}
