#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "contactd/section_warnings.hpp"
#include "section/spectrum/spectrum_build.hpp"
#include "section/triangulation.hpp"
#include "section_cases.hpp"
#include "sections_reference.hpp"

using namespace contactd;
using namespace contactd::fem;

namespace {

using reference_sections::ds, reference_sections::Entry, reference_sections::nu, reference_sections::self;
using enum Axis;

struct Component {
    Axis i, j;
    double Entry::* value;
};
constexpr std::array components{Component{z, z, &Entry::zz}, Component{x, x, &Entry::xx}, Component{y, y, &Entry::yy},
                                Component{z, y, &Entry::zy}, Component{y, z, &Entry::yz}, Component{x, z, &Entry::xz}};
/// Returns the coefficient at the offset -k that is equal by Betti's theorem; the reference has none of xz.
double Entry::* opposite(const Component& of) {
    if (of.i == x && of.j == z) return nullptr;
    return of.i == of.j ? of.value : of.value == &Entry::zy ? &Entry::yz : &Entry::zy;
}

/// Returns a coefficient of the reference as in tables: the mean with the one that is equal by Betti's theorem. If the
/// reference lacks it, the error may be half of the defect of reciprocity.
struct Expected {
    double value;
    bool has_opposite;
};
Expected expected(const std::vector<Entry>& entries, const Entry& entry, const Component& component) {
    const double own = entry.*component.value;
    if (const auto other = opposite(component))
        for (const Entry& one : entries)
            if (one.I == entry.J && one.J == entry.I && one.k == entry.k) return {(own + one.*other) / 2, true};
    return {own, false};
}

/// Below 5e-4 the finest mesh may miss the accuracy.
std::optional<SpectrumBuild> build_unless_refused(const SectionOutline& outline, double accuracy) {
    Observer observer;
    try {
        return build_spectrum(MPI_COMM_SELF, outline, nu, accuracy, observer);
    } catch (const NotConverged&) {
        if (accuracy >= 5e-4) throw;
        return {};
    }
}

/// Every coefficient of the reference is met within the stated error, which does not exceed the requested accuracy.
void check_references(double accuracy) {
    constexpr double rounding = 0.5e-6;  // rounding of the reference's last digit
    for (const auto& one : reference_sections::cases()) {
        const auto reached = build_unless_refused(one.outline, accuracy);
        if (!reached) continue;
        const SpectrumBuild& build = *reached;
        const StripTable table = strip_table(build.spectrum, 1, 101, 0, ds);
        CAPTURE(one.name, accuracy, build.errors.mesh, build.errors.wavenumbers, build.errors.end);
        // The defect of reciprocity, which no mesh reduces, may exceed the accuracy, with a warning.
        CHECK(build.errors.numerical() <= accuracy);
        const double allowed = (build.errors.total() + one.own_error) * self + rounding;
        for (const Entry& entry : one.entries)
            for (const Component& component : components) {
                const auto [value, has_opposite] = expected(one.entries, entry, component);
                CAPTURE(entry.I, entry.J, entry.k, component.i, component.j, value);
                const double found = table(component.i, component.j, entry.I, entry.J, entry.k);
                CHECK(std::abs(found - value) <= allowed + (has_opposite ? 0 : build.errors.reciprocity / 2 * self));
            }
    }
}

void check_layers(double accuracy) {
    constexpr double rounding = 0.5e-7;
    for (const auto& one : reference_sections::layers()) {
        const auto reached = build_unless_refused(one.outline, accuracy);
        if (!reached) continue;
        const SpectrumBuild& build = *reached;
        const StripTable table = strip_table(build.spectrum, 1, 7, 0, ds);
        CAPTURE(one.name, accuracy, build.errors.mesh, build.errors.wavenumbers, build.errors.end);
        // The defect of reciprocity, which no mesh reduces, may exceed the accuracy, with a warning.
        CHECK(build.errors.numerical() <= accuracy);
        const double allowed = build.errors.total() * self + rounding;
        constexpr int loaded = 7;
        for (const auto& [k, l, zz, xx, yy] : one.entries) {
            CAPTURE(k, l);
            CHECK(std::abs(table(z, z, loaded + l, loaded, k) - zz) <= allowed);
            CHECK(std::abs(table(x, x, loaded + l, loaded, k) - xx) <= allowed);
            CHECK(std::abs(table(y, y, loaded + l, loaded, k) - yy) <= allowed);
        }
    }
}

}  // namespace

TEST_CASE("Tables of sections meet the reference within the error they state", "[section]") {
    check_references(1e-2);
    check_layers(1e-2);
}

// Slow: it uses meshes of accuracy 1e-3 for each outline.
TEST_CASE("So do finer tables", "[section][slow]") {
    check_references(1e-3);
    check_layers(1e-3);
}

// Long: it uses meshes of accuracy 1e-4.
TEST_CASE("So do the finest tables", "[section][long]") {
    check_references(1e-4);
    check_layers(1e-4);
}

// Far from a load, a disc on a core rotates like a shaft on an elastic foundation. Its angle decreases as exp(-lambda
// x), with lambda^2 = 4 pi/(1/r^2 - 1/R^2)/(pi R^4/2), over 70 radii for a core of 0.005 R.
TEST_CASE("A disc turns about a small core as a long shaft does", "[section]") {
    const double accuracy = GENERATE(1e-2, 3e-3);
    constexpr int strips = 40, offsets = 400;
    constexpr double core = 0.005;
    Observer observer;
    const SpectrumBuild build = build_spectrum(MPI_COMM_SELF, disc(strips, core), nu, accuracy, observer);
    CHECK(build.errors.numerical() <= accuracy);
    const StripTable table = strip_table(build.spectrum, 1, offsets);
    const double pi = std::numbers::pi, R = strips / (2 * pi), r = core * R;
    const double foundation = 4 * pi / (1 / (r * r) - 1 / (R * R)), stiffness = pi * std::pow(R, 4) / 2,
                 lambda = std::sqrt(foundation / stiffness);
    const double scale = half_space_coefficient(z, z, 0, 0, 1, 1, {.G = 1, .nu = nu});
    constexpr double of_theory = 1e-3;  // 2 (lambda R)^2, plus the shear of the core's neighbourhood
    for (const int k : {40, 100, 200, 399}) {
        CAPTURE(accuracy, k);
        const double torque = 2 * pi * R * R,  // unit tractions on a ring as long as a strip is wide
            expected = R * torque * std::exp(-lambda * k) / (2 * std::sqrt(foundation * stiffness));
        double sum = 0;
        for (int J = 0; J < strips; ++J) sum += table(y, y, 7, J, k);
        CHECK(std::abs(sum - expected) <= strips * build.errors.total() * scale + of_theory * expected);
    }
}

TEST_CASE("Strips beside an edge are tabulated to any accuracy that meshes reach, and their error is stated",
          "[section]") {
    const auto sentences = [](double accuracy) {
        Observer observer;
        const SpectrumBuild build = build_spectrum(MPI_COMM_SELF, edge_block(20, 10, 0.5, 4), nu, accuracy, observer);
        CHECK(build.errors.numerical() <= accuracy);
        CHECK(build.errors.total() > accuracy);
        SectionEvidence evidence;
        evidence.error = build.errors.total();
        evidence.reciprocity_defect = build.errors.reciprocity;
        return section_warnings(accuracy, evidence).size();
    };
    for (const double accuracy : {1e-3, 4e-4}) CHECK(sentences(accuracy) == 1);
}

TEST_CASE("Layers that are long and thin are filled with triangles", "[section]") {
    const double thickness = GENERATE(0.23, 0.185376215151, 0.1, 0.05), width = GENERATE(24.9268213656, 50, 165, 400);
    const int strips = GENERATE(2, 4);
    const double poissons_ratio = GENERATE(0.3, 0.42);
    const SectionOutline outline = slab(width / 2, thickness, strips);
    const MeshDensity density = density_for(1e-2, poissons_ratio);
    const Triangulation triangulation = triangulate(divide(outline, density), density);
    double area = 0;
    for (const auto& [a, b, c] : triangulation.triangles) {
        const PlanePoint &A = triangulation.vertices[a], &B = triangulation.vertices[b], &C = triangulation.vertices[c];
        const double twice = (B.y - A.y) * (C.z - A.z) - (B.z - A.z) * (C.y - A.y);
        REQUIRE(twice > 0);
        area += twice / 2;
    }
    CHECK(std::abs(area - width * thickness) <= 1e-9 * area);
}

TEST_CASE("A slab that is thick and wide is a half-space", "[section]") {
    Observer observer;
    const SpectrumBuild build = build_spectrum(MPI_COMM_SELF, slab(2e5, 2e5, 20), nu, 1e-3, observer);
    const StripTable table = strip_table(build.spectrum, 1, 40);
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
