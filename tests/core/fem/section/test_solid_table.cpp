// Compares three-dimensional meshes and coefficients of a few strips with the transform along x.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "build/solid_table.hpp"
#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "section/spectrum/spectrum_build.hpp"
#include "section_cases.hpp"

using namespace contactd;
using namespace contactd::fem;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double nu = 0.28;

/// Uses the paper's solver, and a factorisation for higher orders.
SolidSpec coarse(int order) {
    SolidSpec spec{.solver = order <= 2 ? Solver::amg_pcg : Solver::direct, .order = order, .nx = 6};
    spec.density = {.edges_a_strip = 2, .growth = 0.8, .edges_a_body = 4, .corner_share = 0.3};
    spec.slices = {.growth = 1.6, .length = 30};
    return spec;
}

SectionOutline small_edge() {
    return edge_block(12, 6, 0.5, 2);
}

double largest_difference(const StripTable& one, const StripTable& other) {
    REQUIRE(one.values.size() == other.values.size());
    double largest = 0;
    for (std::size_t i = 0; i < one.values.size(); ++i)
        largest = std::max(largest, std::abs(one.values[i] - other.values[i]));
    return largest / half_space_coefficient(Axis::z, Axis::z, 0, 0, 1, 1, {.G = 1, .nu = nu});
}

BlockMesh mesh_of(const SectionOutline& outline, int strip) {
    const SolidSpec spec = coarse(1);
    const DividedOutline divided = divide(outline, spec.density);
    return make_solid_mesh(outline, divided, triangulate(divided, spec.density), strip, spec.slices);
}

/// Returns the area of each BoundaryPart.
std::array<double, 5> boundary_areas(mfem::Mesh& mesh) {
    std::array<double, 5> areas{};
    for (int i = 0; i < mesh.GetNBE(); ++i) {
        mfem::ElementTransformation& map = *mesh.GetBdrElementTransformation(i);
        map.SetIntPoint(&mfem::Geometries.GetCenter(mesh.GetBdrElementGeometry(i)));
        const double reference = mesh.GetBdrElementGeometry(i) == mfem::Geometry::TRIANGLE ? 0.5 : 1;
        areas[static_cast<std::size_t>(mesh.GetBdrAttribute(i) - 1)] += reference * map.Weight();
    }
    return areas;
}

}  // namespace

TEST_CASE("An extruded section is the half of a uniform body, clamped where that is and at its end",
          "[section][mesh]") {
    const int strip = GENERATE(0, 1);
    BlockMesh block = mesh_of(small_edge(), strip);
    double volume = 0;
    for (int i = 0; i < block.mesh.GetNE(); ++i) {
        CHECK(block.mesh.GetElementVolume(i) > 0);
        volume += block.mesh.GetElementVolume(i);
    }
    CHECK_THAT(volume, WithinRel(12.0 * 6 * 30, 1e-12));
    const auto [front, right, free, loaded, far] = boundary_areas(block.mesh);
    CHECK_THAT(front, WithinRel(72.0, 1e-12));
    CHECK(right == 0);  // no plane of symmetry across y
    CHECK_THAT(loaded, WithinRel(0.5, 1e-12));
    CHECK_THAT(far, WithinRel(72.0 + (12 + 6) * 30, 1e-12));
    CHECK_THAT(free, WithinRel((12.0 + 6) * 30 - 0.5, 1e-12));
}

TEST_CASE("Points of its strips are found in their elements", "[section][mesh]") {
    BlockMesh block = mesh_of(small_edge(), 1);
    for (const double X : {0.0, 0.3, 0.5, 2.0, 21.0, 30.0})
        for (const double Y : {-0.5, 0.0, 0.25, 0.9, 1.0, 1.5}) {
            const ElementPoint place = block.locate(X, Y);
            mfem::Vector at;
            block.mesh.GetElementTransformation(place.element)->Transform(place.point, at);
            CAPTURE(X, Y);
            CHECK_THAT(at[0], WithinAbs(-X, 1e-12));
            CHECK_THAT(at[1], WithinAbs(-Y, 1e-12));
            CHECK_THAT(at[2], WithinAbs(0, 1e-12));
        }
}

TEST_CASE("Strips that are not level are refused in three dimensions", "[section][mesh]") {
    CHECK_THROWS_AS(mesh_of(groove(6, 20, 20, 5), 0), InvalidArgument);
}

// Slow: it uses finite elements in three dimensions.
TEST_CASE("Three dimensions and the transform agree on a block with an edge", "[section][slow]") {
    Observer observer;
    const SectionOutline outline = small_edge();
    const SpectrumBuild build = build_spectrum(MPI_COMM_SELF, outline, nu, 5e-4, observer);
    const StripTable transformed = strip_table(build.spectrum, 1, coarse(1).nx);
    const auto solid = [&](const SolidSpec& spec) {
        return build_solid_table(MPI_COMM_SELF, outline, nu, spec, observer).table;
    };
    SolidSpec shorter = coarse(2);
    shorter.slices.length = 20;
    const StripTable second = solid(coarse(2)), third = solid(coarse(3));
    // The change by one order more is most of the error of the lower one. A body that is a third shorter ends too far
    // away to matter.
    const double left = largest_difference(third, second), ended = largest_difference(solid(shorter), second);
    CAPTURE(build.errors.total(), left, ended, largest_difference(second, transformed));
    CHECK(largest_difference(third, transformed) <= build.errors.total() + left / 2 + ended);
    CHECK(largest_difference(second, transformed) > 2 * largest_difference(third, transformed));
}
