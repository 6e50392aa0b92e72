#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "contactd/subsurface.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;

namespace {

using Point = std::array<double, 3>;
using Tensor = std::array<double, 6>;  // xx, yy, zz, xy, xz, yz

const Grid grid = Grid::of_elements(5, 4, 1, 0.8);

SurfaceTractions uneven() {
    SurfaceTractions tractions;
    for (int i = 0; i < 20; ++i) {
        tractions.x.push_back(std::sin(1.3 * i));
        tractions.y.push_back(std::cos(2.1 * i));
        tractions.z.push_back(-1 - std::sin(0.7 * i));
    }
    return tractions;
}

Tensor at(const SubsurfaceStress& s, std::size_t i) {
    return {s.xx[i], s.yy[i], s.zz[i], s.xy[i], s.xz[i], s.yz[i]};
}

Tensor stress(const Layers& body, const Point& point) {
    Observer observer;
    return at(subsurface_stress(grid, uneven(), body, std::vector<Point>{point}, observer), 0);
}

void check_equal(const SubsurfaceStress& a, const SubsurfaceStress& b, double tolerance) {
    REQUIRE(a.xx.size() == b.xx.size());
    for (std::size_t i = 0; i < a.xx.size(); ++i) {
        CAPTURE(i);
        for (std::size_t c = 0; c < 6; ++c) CHECK_THAT(at(a, i)[c], WithinAbs(at(b, i)[c], tolerance));
        CHECK_THAT(a.von_mises[i], WithinAbs(b.von_mises[i], 10 * tolerance));
    }
}

const Layers stiff_on_soft{{{0.4, 5, 0.25}, {1.1, 0.5, 0.5}}, {2, 0.3}};
const Layers on_rigid_base{{{0.7, 1, 0.3}, {1.5, 4, 0.2}}, Material::rigid()};

}  // namespace

TEST_CASE("stresses in layers of one material are those of the half-space", "[subsurface]") {
    const double nu = GENERATE(0.0, 0.3, 0.5);
    const Layers layers{{{0.3, 5, nu}, {0.02, 5, nu}, {7, 5, nu}}, {5, nu}};
    const StressBlock block{{-30, -1.5, -0.7, 0.25, 3}, {-0.4, 0, 1, 40}, {0, -0.1, -0.3, -0.301, -0.35, -2, -7.5}};
    Observer observer;
    check_equal(subsurface_stress(grid, uneven(), layers, block, observer),
                subsurface_stress(grid, uneven(), nu, block, observer), 1e-11);
}

TEST_CASE("stresses in layers are in equilibrium", "[subsurface]") {
    const Layers body = GENERATE(stiff_on_soft, on_rigid_base);
    const double z = GENERATE(-0.3, -0.9, -1.8);
    constexpr double h = 1e-3;
    const auto slope = [&](std::size_t axis, std::size_t component) {
        const auto moved = [&](double by) {
            Point point{0.3, -0.55, z};
            point[axis] += by;
            return stress(body, point)[component];
        };
        return (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
    };
    CAPTURE(z);
    CHECK_THAT(slope(0, 0) + slope(1, 3) + slope(2, 4), WithinAbs(0, 1e-8));
    CHECK_THAT(slope(0, 3) + slope(1, 1) + slope(2, 5), WithinAbs(0, 1e-8));
    CHECK_THAT(slope(0, 4) + slope(1, 5) + slope(2, 2), WithinAbs(0, 1e-8));
}

TEST_CASE("tractions on the surface of layers are those that act there", "[subsurface]") {
    const Layers body = GENERATE(stiff_on_soft, on_rigid_base);
    const SurfaceTractions given = uneven();
    for (const int element : {0, 7, 19}) {
        const Tensor s = stress(body, {grid.x(element % 5), grid.y(element / 5), 0});
        const auto e = static_cast<std::size_t>(element);
        CHECK_THAT(s[2], WithinAbs(given.z[e], 1e-9));
        CHECK_THAT(s[4], WithinAbs(given.x[e], 1e-9));
        CHECK_THAT(s[5], WithinAbs(given.y[e], 1e-9));
    }
    CHECK_THAT(stress(body, {4, 0.1, 0})[2], WithinAbs(0, 1e-9));
}

TEST_CASE("tractions and strains go on from layer to layer, stresses along the layers jump", "[subsurface]") {
    const double z = GENERATE(-0.4, -1.5);
    const auto [G, nu, G_below, nu_below] =
        z == -0.4 ? std::array{5.0, 0.25, 0.5, 0.5} : std::array{0.5, 0.5, 2.0, 0.3};
    const auto strains = [](const Tensor& s, double shear_modulus, double ratio) {
        const double E = 2 * shear_modulus * (1 + ratio);
        return std::array{(s[0] - ratio * (s[1] + s[2])) / E, (s[1] - ratio * (s[0] + s[2])) / E, s[3] / shear_modulus};
    };
    for (const Point& point : {Point{0.3, -0.55, z}, Point{-2.5, 0, z}, Point{6, 1, z}}) {
        const Tensor above = stress(stiff_on_soft, point);
        const Tensor below = stress(stiff_on_soft, {point[0], point[1], z - 1e-9});
        for (const std::size_t c : {2U, 4U, 5U}) CHECK_THAT(above[c], WithinAbs(below[c], 1e-7));
        const auto of_upper = strains(above, G, nu), of_lower = strains(below, G_below, nu_below);
        for (std::size_t c = 0; c < 3; ++c) CHECK_THAT(of_upper[c], WithinAbs(of_lower[c], 1e-7));
        CHECK(std::abs(above[0] - below[0]) > 1e-4);
    }
}

TEST_CASE("a deep layer is felt no more than its depth says", "[subsurface]") {
    const Layers deep{{{1e3, 1, 0.3}}, Material::rigid()};
    Observer observer;
    const StressBlock block{{0, 0.3}, {0.1}, {0, -0.2, -3}};
    check_equal(subsurface_stress(grid, uneven(), deep, block, observer),
                subsurface_stress(grid, uneven(), 0.3, block, observer), 1e-4);
}

TEST_CASE("points of a lattice have the stresses that they have alone", "[subsurface]") {
    Observer observer;
    const StressBlock block{{-1.75, 0.25, 1.25, 2.25, 2.3}, {-0.4, 0.4, 1.2}, {-0.2, -0.9}};
    const SubsurfaceStress together = subsurface_stress(grid, uneven(), stiff_on_soft, block, observer);
    std::size_t i = 0;
    for (const double z : block.z)
        for (const double y : block.y)
            for (const double x : block.x) {
                const Tensor alone = stress(stiff_on_soft, {x, y, z});
                for (std::size_t c = 0; c < 6; ++c) CHECK_THAT(at(together, i)[c], WithinAbs(alone[c], 1e-11));
                ++i;
            }
}

TEST_CASE("thin layers far from the load have stresses that are numbers", "[subsurface]") {
    const Layers thin{{{1e-3, 3, 0.3}, {1e-3, 1, 0.499}}, {1, 0.3}};
    for (const Point& point : {Point{0, 0, 0}, Point{0.5, 0.4, -1e-3}, Point{1e6, 0, -1.5e-3}, Point{0, 3, -1e4}})
        for (const double value : stress(thin, point)) {
            CHECK(std::isfinite(value));
            CHECK(std::abs(value) < 1e3);
        }
}

TEST_CASE("nothing is asked of a rigid base", "[subsurface]") {
    Observer observer;
    const auto refused = [&](const auto& points) -> std::string {
        try {
            subsurface_stress(grid, uneven(), on_rigid_base, points, observer);
        } catch (const InvalidArgument& error) {
            return std::string(error.field()) + ": " + error.what();
        }
        return "";
    };
    CHECK(refused(std::vector<Point>{{0, 0, -2.2}}).empty());
    CHECK(refused(std::vector<Point>{{0, 0, -2.3}}).find("points") == 0);
    CHECK(refused(StressBlock{{0}, {0}, {-1, -3}}).find("rigid base") != std::string::npos);
    CHECK(refused(StressBlock{{0}, {0}, {-1, -3}}).find("block.z") == 0);
}
