// FASTSIM integrates four slices, or rows of elements, side by side. They must not affect each other.
#include "closed_forms/simplified/fastsim_ellipse.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cfenv>
#include <cmath>
#include <numbers>
#include <random>

#include "closed_forms/simplified/fastsim.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;

namespace {

const Material steel{82000, 0.28};
const EllipticContact contact{{6, 4}, 50000, steel};
constexpr double mu = 0.3, bound = mu * 50000;

/// Creepages range from nearly no slip to far beyond full slip.
FastsimCreepages<double> random_creepages(std::mt19937& random) {
    std::uniform_real_distribution<double> exponent(-5, -1), sign(-1, 1);
    const auto one = [&] { return sign(random) * std::pow(10, exponent(random)); };
    return {one(), one(), 0.2 * one()};
}

Rolling rolling_of(const FastsimCreepages<double>& creepages, double chi = 0) {
    Rolling rolling;
    rolling.xi = creepages.xi;
    rolling.eta = creepages.eta;
    rolling.phi = creepages.phi;
    rolling.chi = chi;
    return rolling;
}

}  // namespace

TEST_CASE("Slices that FASTSIM follows side by side carry what each carries alone", "[fastsim]") {
    const FastsimSettings settings{48, GENERATE(8, 12, 13, 31)};
    const FastsimEllipse ellipse(rolling_frame(contact.axes, 0), steel, 2 * bound / contact.area(), settings);
    const FastsimNodes nodes(settings);
    std::mt19937 random(static_cast<unsigned>(settings.slices));
    for (int i = 0; i < 50; ++i) {
        const FastsimCreepages<double> creepages = random_creepages(random);
        const FastsimTotals<double> together = ellipse.totals(creepages);
        FastsimTotals<double> alone;
        for (int k = 0; k < settings.slices; ++k) {
            const auto group = static_cast<std::size_t>(k / 4);
            const double y = contact.axes.b * nodes.heights[group].value[k % 4];
            const double dy = contact.axes.b * nodes.widths[group].value[k % 4];
            const double half = ellipse.half_chord(y);
            FastsimPoint<double> point{{half, 0, 0}};
            SliceSums<double> sum;
            for (const double position : nodes.positions)
                point = advance(ellipse.law(creepages), ellipse.slice(creepages, y), point, half * position, sum);
            alone.Fx += dy * sum.px;
            alone.Fy += dy * sum.py;
            alone.Mz += dy * (sum.x_py - y * sum.px);
            alone.slip_area += dy * sum.slip;
        }
        CHECK_THAT(together.Fx, WithinAbs(alone.Fx, 1e-11 * bound));
        CHECK_THAT(together.Fy, WithinAbs(alone.Fy, 1e-11 * bound));
        CHECK_THAT(together.Mz, WithinAbs(alone.Mz, 1e-10 * bound));
        CHECK_THAT(together.slip_area, WithinAbs(alone.slip_area, 1e-9 * contact.area()));
    }
}

TEST_CASE("FASTSIM's sums are the same with their derivatives and without", "[fastsim]") {
    const FastsimEllipse ellipse(rolling_frame(contact.axes, 0), steel, 2 * bound / contact.area(), {});
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
        const FastsimCreepages<double> creepages = random_creepages(random);
        const FastsimTotals<double> plain = ellipse.totals(creepages);
        const FastsimTotals<Dual> dual = ellipse.totals(FastsimCreepages<Dual>{
            Dual::input(creepages.xi, 0), Dual::input(creepages.eta, 1), Dual::input(creepages.phi, 2)});
        CHECK_THAT(dual.Fx.value, WithinAbs(plain.Fx, 1e-11 * bound));
        CHECK_THAT(dual.Fy.value, WithinAbs(plain.Fy, 1e-11 * bound));
        CHECK_THAT(dual.Mz.value, WithinAbs(plain.Mz, 1e-10 * bound));
        CHECK_THAT(dual.power.value, WithinAbs(plain.power, 1e-11 * bound));
        CHECK_THAT(dual.slip_area.value, WithinAbs(plain.slip_area, 1e-9 * contact.area()));
    }
}

TEST_CASE("A row of elements has the same FASTSIM tractions whatever rows are beside it", "[fastsim]") {
    const double chi = GENERATE(0.0, std::numbers::pi);
    const Grid grid = Grid::of_elements(30, 23, 0.43, 0.37);
    std::mt19937 random(1);
    for (int i = 0; i < 20; ++i) {
        const Rolling rolling = rolling_of(random_creepages(random), chi);
        const EllipticFriction all = fastsim(grid, contact, mu, rolling);
        for (int iy = 0; iy < grid.ny; ++iy) {
            Grid row = grid;
            row.ny = 1;
            row.y0 = grid.y0 + iy * grid.dy;
            const EllipticFriction one = fastsim(row, contact, mu, rolling);
            for (std::size_t ix = 0; ix < static_cast<std::size_t>(grid.nx); ++ix) {
                const std::size_t at = static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + ix;
                CHECK_THAT(all.traction_x[at], WithinAbs(one.traction_x[ix], 1e-9));
                CHECK_THAT(all.traction_y[at], WithinAbs(one.traction_y[ix], 1e-9));
                CHECK_THAT(all.slip_x[at], WithinAbs(one.slip_x[ix], 1e-10));
                CHECK(all.element_division[at] == one.element_division[ix]);
            }
        }
    }
}

TEST_CASE("FASTSIM's tractions in a mirror are those of the mirrored motion", "[fastsim]") {
    const int ny = GENERATE(9, 10, 11, 12);
    const Grid grid = Grid::of_elements(20, ny, 0.65, 8.5 / ny);
    std::mt19937 random(static_cast<unsigned>(ny));
    for (int i = 0; i < 20; ++i) {
        const FastsimCreepages<double> creepages = random_creepages(random);
        const EllipticFriction left = fastsim(grid, contact, mu, rolling_of(creepages)),
                               right = fastsim(grid, contact, mu,
                                               rolling_of({creepages.xi, -creepages.eta, -creepages.phi}));
        CHECK_THAT(left.Fy, WithinAbs(-right.Fy, 1e-11 * bound));
        for (int iy = 0; iy < ny; ++iy)
            for (int ix = 0; ix < grid.nx; ++ix) {
                const auto here = static_cast<std::size_t>(iy * grid.nx + ix),
                           there = static_cast<std::size_t>((ny - 1 - iy) * grid.nx + ix);
                CHECK_THAT(left.traction_x[here], WithinAbs(right.traction_x[there], 1e-9));
                CHECK_THAT(left.traction_y[here], WithinAbs(-right.traction_y[there], 1e-9));
            }
    }
}

TEST_CASE("FASTSIM divides nothing by zero, which programs around it may trap", "[fastsim]") {
    std::mt19937 random(2);
    std::feclearexcept(FE_ALL_EXCEPT);
    for (int i = 0; i < 200; ++i) {
        FastsimCreepages<double> creepages = random_creepages(random);
        if (i % 4 == 0) creepages.phi = 0;
        if (i % 8 == 0) creepages.xi = creepages.eta = 0;
        fastsim(Grid::of_elements(25, 25, 0.5, 0.35), contact, i % 16 == 0 ? 0 : mu, rolling_of(creepages));
    }
    CHECK(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW) == 0);
}
