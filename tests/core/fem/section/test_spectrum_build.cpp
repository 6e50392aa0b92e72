#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "contactd/half_space.hpp"
#include "section/spectrum_build.hpp"
#include "section_cases.hpp"

using namespace contactd;
using namespace contactd::fem;

namespace {

/// Entries of the reference, times G, for ds = dx = 0.5 mm and nu = 0.28.
struct Entry {
    int I, J, k;
    double nn, xx, ss;
};
struct Case {
    std::string name;
    SectionOutline outline;
    double own_error;  ///< of the reference, over zz of the half-space
    std::vector<Entry> entries;
};

constexpr double ds = 0.5, nu = 0.28, self = 0.2019960;

std::vector<Case> cases() {
    return {{"edge at half an element",
             edge_block(200, 100, 0.5, 20),
             3e-4,
             {{19, 19, 0, 0.250978, 0.274743, 0.362838},
              {19, 19, 1, 0.103133, 0.108592, 0.157704},
              {19, 19, 20, 0.006798, 0.006994, 0.007826},
              {15, 19, 4, 0.021020, 0.019830, 0.037429}}},
            {"edge at two elements",
             edge_block(200, 100, 2, 20),
             1e-4,
             {{19, 19, 0, 0.220063, 0.254131, 0.289177},
              {19, 19, 4, 0.028085, 0.028865, 0.042699},
              {19, 15, 1, 0.022363, 0.020481, 0.043553},
              {15, 19, 20, 0.005527, 0.006303, 0.007778}}},
            {"edge at ten elements",
             edge_block(200, 100, 10, 20),
             4e-5,
             {{19, 19, 0, 0.204606, 0.243576, 0.251318},
              {19, 19, 20, 0.004223, 0.005205, 0.007365},
              {15, 19, 4, 0.011940, 0.013804, 0.019937}}},
            {"groove",
             groove(20, 120, 140, 41),
             3.2e-4,
             {{20, 20, 0, 0.199581, 0.237147, 0.233193},
              {30, 30, 1, 0.057976, 0.077373, 0.057267},
              {30, 20, 4, 0.002951, 0.004038, 0.003606},
              {10, 30, 20, 0.000236, 0.001392, 0.000736}}},
            {"round end",
             round_end(19.4, 120, 41),
             3e-4,
             {{20, 20, 0, 0.205860, 0.250144, 0.393966},
              {30, 30, 1, 0.082836, 0.088857, 0.184219},
              {30, 20, 4, 0.007539, 0.011385, 0.137559},
              {10, 30, 20, -0.017496, 0.006312, 0.108584}}},
            {"bonded layer of one element",
             slab(200, 1, 20),
             1e-6,
             {{10, 10, 0, 0.1295842, 0.1944184, 0.1944184},
              {10, 10, 1, 0.0070523, 0.0417956, 0.0223500},
              {11, 10, 0, 0.0070523, 0.0223500, 0.0417956},
              {13, 10, 2, -0.0000235, 0.0004848, 0.0012078}}},
            {"bonded layer of five elements",
             slab(200, 5, 20),
             1e-6,
             {{10, 10, 0, 0.1864990, 0.2315221, 0.2315221},
              {10, 10, 1, 0.0442508, 0.0707208, 0.0520611},
              {11, 10, 0, 0.0442508, 0.0520611, 0.0707208},
              {13, 10, 2, 0.0033881, 0.0091835, 0.0116286}}}};
}

/// Every coefficient of the reference is met within the error that is stated, which is no more than was asked for.
void check_cases(double accuracy) {
    for (const Case& one : cases()) {
        Observer observer;
        const SpectrumBuild build = build_spectrum(MPI_COMM_SELF, one.outline, nu, accuracy, observer);
        const ColumnTable table = column_table(build.spectrum, 1, 21, 0, ds);
        CAPTURE(one.name, accuracy, build.errors.mesh, build.errors.wavenumbers, build.errors.end);
        CHECK(build.errors.total() <= accuracy);
        const double allowed = build.errors.total() + one.own_error;
        for (const auto& [I, J, k, nn, xx, ss] : one.entries) {
            CAPTURE(I, J, k);
            // The reference was not made symmetric.
            const double halved = one.name.starts_with("edge") && I != J ? 4e-4 : 0;
            CHECK(std::abs(table(Axis::z, Axis::z, I, J, k) - nn) / self <= allowed + halved);
            CHECK(std::abs(table(Axis::x, Axis::x, I, J, k) - xx) / self <= allowed + halved);
            CHECK(std::abs(table(Axis::y, Axis::y, I, J, k) - ss) / self <= allowed + halved);
        }
    }
}

}  // namespace

TEST_CASE("Tables of sections meet the reference within the error they state", "[section]") {
    check_cases(1e-2);
}

TEST_CASE("So do finer tables", "[section][slow]") {
    check_cases(GENERATE(1e-3, 1e-4));
}

TEST_CASE("A slab that is thick and wide is a half-space", "[section]") {
    Observer observer;
    const SpectrumBuild build = build_spectrum(MPI_COMM_SELF, slab(2e5, 2e5, 20), nu, 1e-3, observer);
    const ColumnTable table = column_table(build.spectrum, 1, 40);
    double largest = 0;
    for (const Axis i : {Axis::x, Axis::y, Axis::z})
        for (const Axis j : {Axis::x, Axis::y, Axis::z})
            for (int I = 0; I < 20; ++I)
                for (int k = 0; k < 40; ++k)
                    largest =
                        std::max(largest, std::abs(table(i, j, I, 3, k) -
                                                   half_space_coefficient(i, j, k, I - 3, 1, 1, {.G = 1, .nu = nu})));
    CHECK(largest < 1e-3 * 0.403992);
}

TEST_CASE("A build for several processes is that of one", "[section]") {
    Observer observer;
    const auto outline = edge_block(50, 30, 2, 6);
    const SpectrumBuild world = build_spectrum(MPI_COMM_WORLD, outline, nu, 1e-2, observer),
                        self_only = build_spectrum(MPI_COMM_SELF, outline, nu, 1e-2, observer);
    CHECK(world.spectrum == self_only.spectrum);
}

TEST_CASE("A build ends when its observer asks for it", "[section]") {
    struct Ending : Observer {
        bool cancelled() const override { return true; }
    } observer;
    CHECK_THROWS_AS(build_spectrum(MPI_COMM_SELF, edge_block(50, 30, 2, 6), nu, 1e-2, observer), Cancelled);
}

TEST_CASE("A build that needs more memory than it may use says so before", "[section]") {
    Observer observer;
    CHECK_THROWS_AS(build_spectrum(MPI_COMM_SELF, edge_block(50, 30, 2, 6), nu, 1e-2, observer, 1000), OutOfMemory);
}
