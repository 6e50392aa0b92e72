// Tests stresses below a line contact: Hertz's pressure and a proportional traction (McEwen; Johnson, Contact
// Mechanics, sections 4.2(c) and 7.1), anti-plane shear, and very long elements.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

#include "contactd/error.hpp"
#include "contactd/subsurface.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Values = std::vector<double>;
using Points = std::vector<std::array<double, 3>>;

namespace {

constexpr double nu = 0.3;
const Points inside{{0, 0, -0.786}, {0.3, 5, -0.5}, {-0.95, -1e6, -0.2}, {1.5, 3, -0.7}, {-4, 0, -2}, {0.4, 0, -8}};

Grid row(int n = 2000) {
    return Grid::of_elements(n, 1, 2.2 / n, 0.7);
}

/// Hertz's pressure with p0 = 1 on |x| < 1.
Values semicircle(const Grid& grid) {
    Values values(grid.size());
    for (int ix = 0; ix < grid.nx; ++ix)
        values[static_cast<std::size_t>(ix)] = std::sqrt(std::max(0.0, 1 - grid.x(ix) * grid.x(ix)));
    return values;
}

/// Johnson (4.49), d the depth.
struct McEwen {
    double m, n, d, xx, dd, xd;

    McEwen(double x, double depth) : d(depth) {
        const double real = 1 - x * x + d * d, size = std::hypot(real, 2 * x * d);
        m = std::sqrt(0.5 * (size + real));
        n = std::copysign(std::sqrt(0.5 * (size - real)), x);
        const double share = (d * d + n * n) / (m * m + n * n);
        xx = -(m * (1 + share) - 2 * d);
        dd = -m * (1 - share);
        xd = -n * (m * m - d * d) / (m * m + n * n);
    }
    /// Returns xx of a traction along x, as large as the pressure.
    double xx_dragged(double x) const { return n * (2 - (d * d - m * m) / (m * m + n * n)) - 2 * x; }
};

SubsurfaceStress at(const Grid& grid, const SurfaceTractions& tractions, const Points& points) {
    Observer observer;
    return subsurface_stress(grid, tractions, PlaneStrain{nu}, points, observer);
}

}  // namespace

TEST_CASE("below a pressed cylinder stresses are McEwen's", "[verification]") {
    const auto stress = at(row(), tractions_on(ContactBody::lower, semicircle(row()), Values(), Values()), inside);
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const auto [x, y, z] = inside[i];
        const McEwen exact(x, -z);
        CHECK_THAT(stress.xx[i], WithinAbs(exact.xx, 2e-5));
        CHECK_THAT(stress.zz[i], WithinAbs(exact.dd, 2e-5));
        CHECK_THAT(stress.xz[i], WithinAbs(-exact.xd, 2e-5));
        CHECK_THAT(stress.yy[i], WithinAbs(nu * (stress.xx[i] + stress.zz[i]), 1e-12));
        CHECK((stress.xy[i] == 0 && stress.yz[i] == 0));
    }
    // The largest shear stress is 0.300 p0 at 0.786 a.
    CHECK_THAT(0.5 * (stress.xx[0] - stress.zz[0]), WithinAbs(0.3003, 1e-4));
}

TEST_CASE("below a sliding cylinder stresses are McEwen's", "[verification]") {
    const auto stress = at(row(), {semicircle(row()), {}, {}}, inside);
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const auto [x, y, z] = inside[i];
        const McEwen pressed(x, -z);
        CHECK_THAT(stress.xx[i], WithinAbs(pressed.xx_dragged(x), 2e-5));
        CHECK_THAT(stress.zz[i], WithinAbs(pressed.xd, 2e-5));
        CHECK_THAT(stress.xz[i], WithinAbs(-pressed.xx, 2e-5));
    }
}

TEST_CASE("a traction along a line contact makes anti-plane shear", "[verification]") {
    const Grid strip = Grid::of_elements(1, 1, 2, 0.7);
    const auto stress = at(strip, {{}, {1}, {}}, inside);
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const auto [x, y, z] = inside[i];
        const double left = std::hypot(x + 1, z), right = std::hypot(x - 1, z);
        CHECK_THAT(stress.xy[i], WithinAbs(std::log(right / left) / std::numbers::pi, 1e-14));
        CHECK_THAT(stress.yz[i],
                   WithinAbs((std::atan((x + 1) / -z) - std::atan((x - 1) / -z)) / std::numbers::pi, 1e-14));
        CHECK((stress.xx[i] == 0 && stress.yy[i] == 0 && stress.zz[i] == 0 && stress.xz[i] == 0));
    }
}

TEST_CASE("a line contact is the limit of long elements, at points and on blocks", "[verification]") {
    const int n = 40;
    Grid grid = Grid::of_elements(n, 1, 0.05, 1e6);
    SurfaceTractions tractions{Values(n), Values(n), Values(n)};
    for (int ix = 0; ix < n; ++ix) {
        const auto e = static_cast<std::size_t>(ix);
        tractions.x[e] = std::cos(ix), tractions.y[e] = std::sin(2.0 * ix), tractions.z[e] = std::sin(ix) - 1;
    }
    StressBlock block{{}, {-2, 0, 100}, {0, -0.01, -0.3}};
    for (int ix = -30; ix < 70; ++ix) block.x.push_back(grid.x0 + (ix + 0.5) * grid.dx);
    block.x.push_back(0.777);  // alone between the others
    Observer observer;
    const auto on_block = subsurface_stress(grid, tractions, PlaneStrain{nu}, block, observer);
    Points points;
    for (const double z : block.z)
        for (const double y : block.y)
            for (const double x : block.x) points.push_back({x, y, z});
    const auto alone = at(grid, tractions, points);
    const auto rectangles = subsurface_stress(grid, tractions, nu, points, observer);
    for (const auto component :
         {&SubsurfaceStress::xx, &SubsurfaceStress::yy, &SubsurfaceStress::zz, &SubsurfaceStress::xy,
          &SubsurfaceStress::xz, &SubsurfaceStress::yz, &SubsurfaceStress::von_mises})
        for (std::size_t i = 0; i < points.size(); ++i) {
            CHECK_THAT((on_block.*component)[i], WithinAbs((alone.*component)[i], 1e-11));
            CHECK_THAT((alone.*component)[i], WithinAbs((rectangles.*component)[i], 2e-4));
        }
}

TEST_CASE("the surface of a line contact carries its tractions", "[verification]") {
    const Grid grid = Grid::of_elements(3, 1, 1, 1);
    const auto stress =
        at(grid, {{0, 0.2, 0}, {0, -0.1, 0}, {-1, -2, -3}}, {{-1, 0, 0}, {0, 0, 0}, {1.5, 0, 0}, {9, 0, 0}});
    CHECK_THAT(stress.zz[0], WithinAbs(-1, 1e-14));
    CHECK_THAT(stress.zz[1], WithinAbs(-2, 1e-14));
    CHECK_THAT(stress.zz[2], WithinAbs(-1.5, 1e-14));  // at an edge, the mean
    CHECK_THAT(stress.zz[3], WithinAbs(0, 1e-14));
    CHECK_THAT(stress.xz[1], WithinAbs(0.2, 1e-14));
    CHECK_THAT(stress.yz[1], WithinAbs(-0.1, 1e-14));
}

TEST_CASE("a line contact has one row of elements, also for its stresses", "[verification]") {
    const Grid grid = Grid::of_elements(2, 2, 1, 1);
    const SurfaceTractions tractions{{}, {}, {-1, -1, -1, -1}};
    try {
        at(grid, tractions, inside);
        FAIL();
    } catch (const InvalidArgument& error) {
        CHECK(error.field() == "grid.ny");
    }
}
