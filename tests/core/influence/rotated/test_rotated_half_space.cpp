#include "influence/rotated/rotated_half_space.hpp"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "circle_of_strips.hpp"
#include "contactd/half_space.hpp"
#include "geometry/section/section_geometry.hpp"
#include "influence/rotated/strip_values.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using enum Axis;
using std::numbers::pi;

namespace {

constexpr std::array axes = {x, y, z};
constexpr double nu = 0.28, self = 0.2019960;  // zz of an element of the half-space on itself, ds = dx = 0.5, G = 1

// Holds nn, xx, ss, ns, sn between two strips.
using Row = std::array<double, 5>;
Row row(const StripTable& table, int I, int J, int k) {
    return {table(z, z, I, J, k), table(x, x, I, J, k), table(y, y, I, J, k), table(z, y, I, J, k),
            table(y, z, I, J, k)};
}

}  // namespace

TEST_CASE("On flat strips the rotated half-space is the half-space", "[rotated]") {
    const LoadShape load = GENERATE(LoadShape::constant, LoadShape::bilinear);
    constexpr int nx = 5, strips = 4;
    IcSpec spec;
    spec.load_shape = load;
    spec.material = {2, nu};
    spec.dx = 0.5;
    spec.dy = 0.3;
    spec.nx = nx;
    spec.ny = strips;
    const IcTable flat = half_space_table(spec);
    std::vector<StripFrame> frames;
    for (int i = 0; i < strips; ++i) frames.push_back({i * 0.3, 1, 0.7});
    const StripTable table = rotated_half_space({frames, 0.3, 0, 0.5, nx}, spec.material, load);
    for (const Axis i : axes)
        for (const Axis j : axes)
            for (int I = 0; I < strips; ++I)
                for (int J = 0; J < strips; ++J)
                    for (int k = 0; k < nx; ++k)
                        CHECK_THAT(table(i, j, I, J, k), WithinAbs(flat.at(i, j, k, I - J), 1e-15));
}

TEST_CASE("A shift by an element is the next offset", "[rotated]") {
    const auto frames = circle(10, 12, 0.5);
    const StripGrid grid{frames, 0.5, 0, 0.4, 6};
    const StripTable table = rotated_half_space(grid, {1, nu}, LoadShape::constant);
    const StripTable ahead = rotated_half_space(grid, {1, nu}, LoadShape::constant, 0.4);
    const StripTable back = rotated_half_space(grid, {1, nu}, LoadShape::constant, -0.4);
    for (const Axis i : axes)
        for (const Axis j : axes)
            for (int I = 0; I < 12; ++I) {
                const double parity = (i == x) != (j == x) ? -1 : 1;
                CHECK_THAT(ahead(i, j, I, 3, 2), WithinAbs(table(i, j, I, 3, 3), 1e-14));
                CHECK_THAT(back(i, j, I, 3, 0), WithinAbs(parity * table(i, j, I, 3, 1), 1e-14));
            }
}

TEST_CASE("The rotated half-space is reciprocal", "[rotated]") {
    const auto frames = circle(GENERATE(8.0, -10.0), 20, 0.5);
    const StripTable table = rotated_half_space({frames, 0.5, 0, 0.4, 6}, {1, nu}, LoadShape::constant);
    for (const Axis i : axes)
        for (const Axis j : axes)
            for (const int k : {0, 1, 5}) {
                const double parity = (i == x) != (j == x) ? -1 : 1;
                CHECK_THAT(table(i, j, 14, 3, k), WithinAbs(parity * table(j, i, 3, 14, k), 1e-15));
            }
}

// A groove of radius 10 by finite elements of order 5 (nu 0.28, ds = dx = 0.5, G = 1): I, J, k, and nn, xx, ss, ns, sn.
TEST_CASE("Rotated by the half-angles the half-space is nearer to a groove than as it is, or rotated the other way",
          "[rotated]") {
    struct Reference {
        int I, J, k;
        Row values;
    };
    constexpr std::array references = {Reference{30, 20, 0, {0.003150, 0.004192, 0.003889, -0.003820, 0.003737}},
                                       Reference{30, 20, 1, {0.003137, 0.004182, 0.003869, -0.003793, 0.003710}},
                                       Reference{30, 20, 4, {0.002951, 0.004038, 0.003606, -0.003440, 0.003356}},
                                       Reference{30, 20, 20, {0.001420, 0.002317, 0.001880, -0.001354, 0.001238}},
                                       Reference{10, 30, 0, {0.000274, 0.001730, 0.000708, 0.002175, -0.002175}},
                                       Reference{10, 30, 4, {0.000274, 0.001710, 0.000714, 0.002130, -0.002130}},
                                       Reference{10, 30, 20, {0.000236, 0.001392, 0.000736, 0.001505, -0.001505}}};
    const auto largest_error = [&](std::vector<StripFrame> frames) {
        const StripTable table = rotated_half_space({frames, 0.5, 0, 0.5, 21}, {1, nu}, LoadShape::constant);
        double largest = 0;
        for (const auto& [I, J, k, values] : references) {
            const Row found = row(table, I, J, k);
            for (std::size_t i = 0; i < values.size(); ++i)
                largest = std::max(largest, std::abs(found[i] - values[i]) / self);
        }
        return largest;
    };
    const auto geometry = geometry::SectionGeometry({Groove{10, 10, 120, 70}}, 41, 0.5);
    const auto frames = geometry.frames();
    auto flat = frames, other_way = frames;
    for (StripFrame& frame : flat) frame.angle = 0;
    for (StripFrame& frame : other_way) frame.angle = -frame.angle;
    const double rotated = largest_error(frames);
    CHECK(rotated < 0.012);
    CHECK(largest_error(flat) > 1.6 * rotated);
    CHECK(largest_error(other_way) > 2.2 * rotated);
}

TEST_CASE("Strips all round a cylinder see each other the shorter way", "[rotated]") {
    constexpr int strips = 30;
    const double ds = 20 * pi / strips;
    const auto frames = circle(10, strips, ds);
    const StripTable table = rotated_half_space({frames, ds, 20 * pi, 0.5, 3}, {1, nu}, LoadShape::constant);
    for (const Axis i : axes)
        for (const Axis j : axes)
            for (int turn = 1; turn < strips; ++turn) {
                const int I = (20 + turn) % strips, J = (8 + turn) % strips;
                CHECK_THAT(table(i, j, I, J, 1), WithinAbs(table(i, j, 20, 8, 1), 1e-12));
            }
}

TEST_CASE("A load along the normal of one strip is seen in the axes of another", "[rotated]") {
    const NineValues normal_only = {0, 0, 0, 0, 0, 0, 0, 0, 1};
    const NineValues rotated = StripAxes(0.6)(normal_only);  // observed +0.3, loaded -0.3
    CHECK_THAT(rotated[8], WithinAbs(std::cos(0.3) * std::cos(0.3), 1e-15));
    CHECK_THAT(rotated[5], WithinAbs(-std::sin(0.3) * std::cos(0.3), 1e-15));  // s leans below the surface there
    CHECK_THAT(rotated[7], WithinAbs(std::sin(0.3) * std::cos(0.3), 1e-15));
    CHECK_THAT(rotated[4], WithinAbs(-std::sin(0.3) * std::sin(0.3), 1e-15));
}
