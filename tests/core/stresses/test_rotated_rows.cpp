// Tests stresses below inclined rows.
#include <array>
#include <cmath>
#include <random>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include "contactd/error.hpp"
#include "contactd/subsurface.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;

namespace {

using Values = std::vector<double>;

const Grid grid = Grid::of_elements(7, 5, 0.5, 0.4);
const StressBlock block{{-1, -0.5, 0, 0.5}, {-0.8, -0.4, 0, 0.4, 0.8}, {0, -0.3, -1}};

SurfaceTractions random_tractions() {
    std::mt19937 generator(4);
    std::uniform_real_distribution<double> uniform(-1, 1);
    SurfaceTractions tractions;
    for (auto* values : {&tractions.x, &tractions.y, &tractions.z})
        for (std::size_t i = 0; i < grid.size(); ++i) values->push_back(uniform(generator));
    return tractions;
}

SubsurfaceStress curved(const SurfaceTractions& tractions, const Values& angles, const SubsurfacePoints& points) {
    Observer observer;
    return subsurface_stress(grid, tractions, 0.28, angles, points, observer);
}

std::array<const Values*, 7> arrays_of(const SubsurfaceStress& s) {
    return {&s.xx, &s.yy, &s.zz, &s.xy, &s.xz, &s.yz, &s.von_mises};
}

void check_equal(const SubsurfaceStress& a, const SubsurfaceStress& b) {
    for (std::size_t c = 0; c < 7; ++c) {
        const Values &of_a = *arrays_of(a)[c], &of_b = *arrays_of(b)[c];
        REQUIRE(of_a.size() == of_b.size());
        for (std::size_t i = 0; i < of_a.size(); ++i) {
            CAPTURE(c, i);
            CHECK_THAT(of_a[i], WithinAbs(of_b[i], 1e-9));
        }
    }
}

}  // namespace

TEST_CASE("Stresses below rows of one inclination are those below a plane") {
    const double angle = GENERATE(0.0, 0.7, -2.0);
    const SurfaceTractions tractions = random_tractions();
    Observer observer;
    check_equal(curved(tractions, Values(5, angle), block), subsurface_stress(grid, tractions, 0.28, block, observer));
}

TEST_CASE("Stresses below curved rows do not depend on the axes that their angles are from") {
    const SurfaceTractions tractions = random_tractions();
    const Values angles{-0.5, -0.2, 0.1, 0.4, 0.9};
    Values rotated = angles;
    for (double& angle : rotated) angle += 1.3;
    check_equal(curved(tractions, angles, block), curved(tractions, rotated, block));
}

TEST_CASE("The surface of a curved row carries its own tractions and no others") {
    const SurfaceTractions tractions = random_tractions();
    const SubsurfaceStress stress = curved(tractions, {-0.5, -0.2, 0.1, 0.4, 0.9}, block);
    for (std::size_t iy = 0; iy < 5; ++iy)
        for (std::size_t ix = 0; ix < block.x.size(); ++ix) {
            const std::size_t at = iy * block.x.size() + ix, element = iy * 7 + ix + 1;
            CHECK_THAT(stress.xz[at], WithinAbs(tractions.x[element], 1e-9));
            CHECK_THAT(stress.yz[at], WithinAbs(tractions.y[element], 1e-9));
            CHECK_THAT(stress.zz[at], WithinAbs(tractions.z[element], 1e-9));
        }
}

TEST_CASE("A pressure on a row at a right angle shears and does not press the row beside it") {
    SurfaceTractions pressure, shear;
    pressure.z.assign(grid.size(), 0);
    shear.y.assign(grid.size(), 0);
    for (std::size_t i = 0; i < 7; ++i) {
        pressure.z[i] = -1;
        shear.y[i] = -1;
    }
    const double right = std::acos(-1) / 2;
    const StressBlock below_last{{0}, {0.8}, {-0.3, -1}};
    Observer observer;
    // The row of the load leans by a right angle, so that its outward normal is the tangent of the others rotated back.
    const SubsurfaceStress rotated = curved(pressure, {0 - right, 0, 0, 0, 0}, below_last);
    check_equal(rotated, subsurface_stress(grid, shear, 0.28, below_last, observer));
}

TEST_CASE("Points and blocks below curved rows have equal stresses") {
    const SurfaceTractions tractions = random_tractions();
    const Values angles{-0.5, -0.2, 0.1, 0.4, 0.9};
    StressPoints points;
    for (const double z : block.z)
        for (const double y : block.y)
            for (const double x : block.x) points.push_back({x, y, z});
    check_equal(curved(tractions, angles, points), curved(tractions, angles, block));
}

TEST_CASE("Angles of another number of rows are refused") {
    CHECK_THROWS_AS(curved(random_tractions(), {0, 0}, block), InvalidArgument);
    CHECK_THROWS_AS(curved(random_tractions(), {0, 0, 0, 0, std::nan("")}, block), InvalidArgument);
}
