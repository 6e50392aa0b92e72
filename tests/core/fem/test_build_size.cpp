// Compares predicted costs of builds with measured ones, and tests the behaviour without enough memory.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "contactd/error.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "fem_specs.hpp"
#include "system/build_size.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;

namespace {

struct Measured {
    FemSpec fem;
    long long dofs;
    double megabytes;  ///< measured largest resident memory of contactd-ic
};

FemSpec mesh(Solver solver, int order, double f, double L_over_h, MeshKind kind = MeshKind::hex) {
    FemSpec fem;
    fem.solver = solver;
    fem.order = order;
    fem.f = f;
    fem.L_over_h = L_over_h;
    fem.mesh = kind;
    return fem;
}

FemSpec adaptive(int order, long long max_dofs) {
    FemSpec fem = mesh(Solver::automatic, order, 1.2, 640, MeshKind::adaptive);
    fem.max_dofs = max_dofs;
    return fem;
}

IcSpec spec_of(const FemSpec& fem) {
    IcSpec spec = paper_spec("paper-test3", 64);
    spec.dx = spec.dy = 1;
    spec.fem = fem;
    return spec;
}

}  // namespace

TEST_CASE("Unknowns and memory are predicted from the mesh", "[fem][size]") {
    constexpr auto direct = Solver::direct, amg = Solver::amg_pcg;
    const Measured measured = GENERATE_COPY(
        Measured{mesh(direct, 1, 1.2, 640), 6414, 71}, Measured{mesh(amg, 1, 1.2, 640), 6414, 64},
        Measured{mesh(direct, 2, 1.5, 640), 24321, 243}, Measured{mesh(amg, 2, 1.5, 640), 24321, 193},
        Measured{mesh(direct, 2, 1.2, 640), 45153, 428}, Measured{mesh(amg, 2, 1.2, 640), 45153, 319},
        Measured{mesh(direct, 2, 1.05, 640), 131085, 1201}, Measured{mesh(amg, 2, 1.05, 640), 131085, 943},
        Measured{mesh(direct, 3, 1.2, 640), 145884, 2020}, Measured{mesh(amg, 3, 1.2, 640), 145884, 1803},
        Measured{mesh(direct, 4, 1.5, 640), 181407, 3366}, Measured{mesh(amg, 4, 1.5, 640), 181407, 3861},
        Measured{mesh(direct, 4, 1.3, 640), 250035, 4805}, Measured{adaptive(2, 20000), 20000, 181},
        Measured{adaptive(2, 60000), 60000, 419}, Measured{adaptive(4, 40000), 40000, 852});
    CAPTURE(measured.dofs, measured.megabytes, name_of(measured.fem.solver));
    const fem::BuildSize size = fem::predicted_size(spec_of(measured.fem), 1);
    CHECK(size.dofs / 3 == measured.dofs / 3);
    CHECK(size.bytes > measured.megabytes * 1048576 / 1.5);
    CHECK(size.bytes < measured.megabytes * 1048576 * 1.5);
}

namespace {

struct MeasuredSection {
    SectionShape shape;
    double accuracy;
    int strips;
    double ds;
    double dofs;
    double megabytes;  ///< 10^6 bytes, 0: not measured, largest resident memory of contactd-ic
    double nu = 0.28;
};

IcSpec spec_of(const MeasuredSection& measured) {
    IcSpec spec;
    spec.material = {1, measured.nu};
    spec.body = BodyShape::longitudinally_uniform;
    spec.source = IcSource::fem;
    spec.accuracy = measured.accuracy;
    spec.ny = measured.strips;
    spec.nx = 10;
    spec.dx = spec.dy = measured.ds;
    spec.section.emplace();
    spec.section->shape = measured.shape;
    return spec;
}

}  // namespace

TEST_CASE("What sections take is predicted from their outlines, rather too much than too little", "[fem][size]") {
    RailSection head, broad;
    head.from = 2;
    broad.from = -20;
    const MeasuredSection measured = GENERATE_COPY(
        MeasuredSection{head, 1e-2, 80, 0.5, 38808, 373}, MeasuredSection{head, 1e-3, 80, 0.5, 78318, 739},
        MeasuredSection{head, 1e-4, 80, 0.5, 139440, 1408}, MeasuredSection{broad, 1e-2, 300, 0.2, 128034, 0},
        MeasuredSection{EdgeBlock{100, 50, 0}, 1e-3, 20, 0.5, 23364, 281},
        MeasuredSection{EdgeBlock{100, 50, 0}, 1e-4, 40, 0.5, 85575, 863, 0.49},
        MeasuredSection{Groove{10, 10, 120, 70}, 1e-3, 41, 0.5, 42378, 448},
        MeasuredSection{Disc{10, 0.05}, 1e-3, 60, 0.5, 60930, 594},
        MeasuredSection{PlateHole{10, 500}, 1e-2, 360, 0.1745, 156168, 0},
        MeasuredSection{Slab{4, 30}, 1e-3, 20, 1, 19752, 0}, MeasuredSection{Slab{1, 300}, 1e-3, 60, 1, 33930, 0});
    CAPTURE(measured.dofs, measured.megabytes);
    const fem::BuildSize size = fem::predicted_size(dimensionless(spec_of(measured)), 1);
    CHECK(static_cast<double>(size.dofs) > 0.99 * measured.dofs);
    CHECK(static_cast<double>(size.dofs) < 1.5 * measured.dofs);
    if (measured.megabytes > 0) {
        CHECK(size.bytes > 1e6 * measured.megabytes);
        CHECK(size.bytes < 1.5e6 * measured.megabytes);
    }
    CHECK(fem::predicted_size(dimensionless(spec_of(measured)), 2).bytes == 2 * size.bytes);
}

TEST_CASE("A section that needs far more memory than it may use is refused before it is meshed", "[fem][size]") {
    Observer observer;
    const IcSpec spec = spec_of(MeasuredSection{Slab{100, 1000}, 1e-4, 900, 1, 0, 0});
    try {
        fem::build_ic_table(spec, observer, 1'000'000'000);
        FAIL("It was built.");
    } catch (const OutOfMemory& error) {
        CHECK(error.field() == "ics.accuracy");
        CHECK_THAT(error.what(), ContainsSubstring("builds.max_memory_bytes") && ContainsSubstring("fewer strips"));
    }
}

TEST_CASE("A build that needs far more memory than it may use is refused before it begins", "[fem][size]") {
    const auto refusal = [](const IcSpec& spec, std::uint64_t limit) -> std::pair<std::string, std::string> {
        Observer observer;
        try {
            fem::build_ic_table(spec, observer, limit);
        } catch (const OutOfMemory& error) {
            return {error.field(), error.what()};
        }
        return {};
    };
    const auto [field, sentence] = refusal(spec_of(mesh(Solver::automatic, 6, 1.01, 640)), 20'000'000'000);
    CHECK(field == "ics");
    CHECK_THAT(sentence, ContainsSubstring("10712397 unknowns") && ContainsSubstring("builds.max_memory_bytes") &&
                             ContainsSubstring("Use order 3"));
    CHECK(refusal(spec_of(adaptive(4, 1'000'000)), 1'000'000'000).first == "ics.max_dofs");

    IcSpec family = spec_of(mesh(Solver::automatic, 2, 2, 1200));
    family.any_nu = true;
    family.nx = family.ny = 1000;
    CHECK(refusal(family, 1'000'000'000).first == "grid");
}
