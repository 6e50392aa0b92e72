#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <vector>

#include "contactd/error.hpp"
#include "section/spectrum/section_model.hpp"
#include "section_cases.hpp"

using namespace contactd;
using namespace contactd::fem;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double nu = 0.28;

SectionMesh mesh_of(const SectionOutline& outline, int order, int edges_a_strip = 4) {
    MeshDensity density;
    density.edges_a_strip = edges_a_strip;
    const DividedOutline divided = divide(outline, density);
    return make_section_mesh(outline, divided, triangulate(divided, density), order);
}

/// Sums over all strips, with equal loads and observations, per strip.
double mean_response(const WaveResponse& response, int strips, int i, int j) {
    double sum = 0;
    for (int I = 0; I < strips; ++I)
        for (int J = 0; J < strips; ++J) {
            const std::size_t a = 3 * I + i, b = 3 * J + j, high = std::max(a, b), low = std::min(a, b);
            sum += response.values[high * (high + 1) / 2 + low];
        }
    return sum / strips;
}

}  // namespace

TEST_CASE("An outline whose edges of elements cross is refused where they do", "[section]") {
    DividedOutline crossed{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}, {0, 4}, 1};
    for (int i = 0; i < 4; ++i) crossed.edges.push_back({0, 0, 0, 1, -1, false, i, (i + 1) % 4});
    REQUIRE_THROWS_WITH(triangulate(crossed, {}), ContainsSubstring("has parts closer to each other"));
}

TEST_CASE("Strips all round a solid cylinder meet the closed form with Bessel functions", "[section]") {
    // R = 10 and G = 1; nothing is clamped.
    struct Case {
        double xi_R, nn, xx, xn, ss;
    };
    const auto [xi_R, nn, xx, xn, ss] = GENERATE(Case{1, 2.7923559, 9.2948680, 1.5369378, 41.6330612},
                                                 Case{5, 1.4744782, 1.4462099, -0.3555476, 2.7803242},
                                                 Case{10, 0.7429830, 0.7264634, -0.2089434, 1.1707062});
    const int strips = 40;
    const SectionOutline outline = disc(strips, 0);
    const SectionMesh mesh = mesh_of(outline, 4);
    SectionModel model(outline, mesh, 4, nu);
    const double radius = strips / (2 * std::numbers::pi), scale = 10 / radius;
    const WaveResponse response = model.at(xi_R / radius);
    CHECK_THAT(scale * mean_response(response, strips, 2, 2), WithinRel(nn, 1e-5));
    CHECK_THAT(scale * mean_response(response, strips, 0, 0), WithinRel(xx, 1e-5));
    CHECK_THAT(scale * mean_response(response, strips, 0, 2), WithinRel(-xn, 1e-5));  // xn has the opposite sign of sin
    CHECK_THAT(scale * mean_response(response, strips, 1, 1), WithinRel(ss, 1e-5));
}

TEST_CASE("A disc under two opposed loads widens across as Michell says", "[section]") {
    // The remainder, -4.4e-4, is due to the core (1.8e-4, proportional to its square) and the width of the loads.
    const int strips = 360;
    const SectionOutline outline = disc(strips, 0.005);
    const SectionMesh mesh = mesh_of(outline, 4, 2);
    SectionModel model(outline, mesh, 4, nu);
    const WaveResponse response = model.at(0);
    // Lists strips about the top (0 and strips - 1 meet there), the right, the bottom and the left. Line loads use two
    // strips each, with traction 1/2 per strip.
    const auto nn = [&](int I, int J) {
        const std::size_t a = 3 * I + 2, b = 3 * J + 2, high = std::max(a, b), low = std::min(a, b);
        return response.values[high * (high + 1) / 2 + low];
    };
    double widening = 0;
    for (const int load : {0, strips - 1, strips / 2 - 1, strips / 2})
        for (const int side : {strips / 4 - 1, strips / 4, 3 * strips / 4 - 1, 3 * strips / 4})
            widening -= nn(side, load) / 4;
    CHECK_THAT(widening, WithinRel(0.238366, 5e-4));
}

TEST_CASE("What nothing holds is refused at wavenumber zero", "[section]") {
    const SectionOutline outline = disc(20, 0);
    const SectionMesh mesh = mesh_of(outline, 2);
    SectionModel model(outline, mesh, 2, nu);
    CHECK_NOTHROW(model.at(0.5));
    CHECK_THROWS_AS(model.at(0), NotConverged);
}

TEST_CASE("A response is reciprocal to the order of its observation at centres", "[section]") {
    const SectionOutline outline = groove(20, 60, 70, 20);
    const SectionMesh mesh = mesh_of(outline, 4);
    SectionModel model(outline, mesh, 4, nu);
    for (const double xi : {0.0, 0.1, 1.0}) CHECK(model.at(xi).reciprocity_defect < 2e-3);
}
