#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "half_space_cases.hpp"
#include "operators/shifted_operator.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

const MaterialPair different{{3, 0.4}, {1, 0.1}};
constexpr std::array tangential_axes = {Axis::x, Axis::y};

// Returns coefficient [i,j] of a pair as a function of the position.
using Exact = std::function<double(Axis, Axis, double, double)>;

Exact half_spaces(const MaterialPair& bodies, LoadShape load_shape, double dx, double dy) {
    return [=](Axis i, Axis j, double x, double y) {
        const auto of = [&](const Material& body) {
            return load_shape == LoadShape::bilinear ? half_space_bilinear_coefficient(i, j, x, y, dx, dy, body)
                                                     : half_space_coefficient(i, j, x, y, dx, dy, body);
        };
        const double sign = (i == Axis::z) != (j == Axis::z) ? -1 : 1;
        return of(bodies.lower) + sign * of(bodies.upper);
    };
}

// Approximates a layer of thickness d: the half-spaces minus nine tenths of point loads at twice that depth.
Exact layer(const MaterialPair& bodies, double dx, double dy, double d) {
    const Exact whole = half_spaces(bodies, LoadShape::constant, dx, dy);
    return [=](Axis i, Axis j, double x, double y) {
        const double r = std::hypot(x, y, 2 * d), xi = i == Axis::x ? x : y, xj = j == Axis::x ? x : y;
        if (j == Axis::z) return whole(i, j, x, y) - 0.9 * dx * dy * 0.06 * xi / (r * r);
        const double image = ((i == j ? 1 / r : 0) + 0.3 * xi * xj / (r * r * r)) * dx * dy / 6;
        return whole(i, j, x, y) - 0.9 * image;
    };
}

IcTable sampled(const Exact& exact, int nx, int ny, double dx, double dy) {
    IcTable table(nx, ny);
    for (const Axis i : axes)
        for (const Axis j : axes)
            for (int l = 0; l < ny; ++l)
                for (int k = 0; k < nx; ++k)
                    if (i != Axis::z) table(i, j, k, l) = exact(i, j, k * dx, l * dy);
    return table;
}

// Returns the largest error over all offsets and components, divided by the largest coefficient.
double error(const ShiftedTable& table, const Exact& exact, const Grid& grid, double shift_x, double shift_y) {
    double largest = 0;
    for (const Axis i : tangential_axes)
        for (const Axis j : axes)
            for (int l = 1 - grid.ny; l < grid.ny; ++l)
                for (int k = 1 - grid.nx; k < grid.nx; ++k)
                    largest = std::max(largest, std::abs(table(i, j, k, l) -
                                                         exact(i, j, k * grid.dx + shift_x, l * grid.dy + shift_y)));
    return largest / std::max(exact(Axis::x, Axis::x, 0, 0), exact(Axis::y, Axis::y, 0, 0));
}

struct Steps {
    double x, y;  // in elements
};

}  // namespace

TEST_CASE("closed form between element centres is that of each point", "[shifted]") {
    const auto steps = GENERATE(Steps{0, 0}, Steps{0.5, 0}, Steps{0, -1.0 / 3}, Steps{0.7, 0.4}, Steps{1, 0},
                                Steps{-2, 1}, Steps{1, 0.25}, Steps{150.5, -3});
    const auto load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const double aspect = GENERATE(1.0, 0.05, 12.0);
    const auto bodies =
        GENERATE(different, MaterialPair{{2, 0.3}, {2, 0.3}}, MaterialPair{Material::rigid(), {5, 0.25}});
    CAPTURE(steps.x, steps.y, int(load_shape), aspect);
    const Grid grid = Grid::of_elements(6, 4, 0.3, 0.3 / aspect);
    const double shift_x = steps.x * grid.dx, shift_y = steps.y * grid.dy;

    const ShiftedTable table = shifted_half_spaces({bodies, load_shape}, grid, shift_x, shift_y);

    CHECK(error(table, half_spaces(bodies, load_shape, grid.dx, grid.dy), grid, shift_x, shift_y) < 2e-12);
}

TEST_CASE("closed form stays accurate on long grids", "[shifted]") {
    const auto load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const Grid grid =
        GENERATE(Grid::of_elements(400, 2, 1, 1), Grid::of_elements(3, 120, 1, 20), Grid::of_elements(60, 60, 1, 1));
    const ShiftedTable table = shifted_half_spaces({different, load_shape}, grid, 0.4 * grid.dx, 0);
    CHECK(error(table, half_spaces(different, load_shape, grid.dx, grid.dy), grid, 0.4 * grid.dx, 0) < 1e-12);
}

TEST_CASE("a shift by whole elements takes the numbers of the table", "[shifted]") {
    const Grid grid = Grid::of_elements(4, 3, 1, 0.7);
    IcTable table(9, 6);
    for (std::size_t i = 0; i < table.values.size(); ++i) table.values[i] = std::sin(7.0 * static_cast<double>(i));
    const auto [steps_x, steps_y] = GENERATE(std::pair{1, 0}, std::pair{0, -1}, std::pair{-2, 3}, std::pair{5, 1});
    // cos(pi/2) and similar values cause rounding errors.
    const ShiftedTable shifted = shifted_table(table, {}, grid, steps_x + 6e-17, steps_y * 0.7 - 6e-17);
    for (const Axis i : tangential_axes)
        for (const Axis j : axes)
            for (int l = -2; l <= 2; ++l)
                for (int k = -3; k <= 3; ++k) CHECK(shifted(i, j, k, l) == table.at(i, j, k + steps_x, l + steps_y));
}

TEST_CASE("tables of half-spaces shift as the closed form does", "[shifted]") {
    const auto load_shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const bool known = GENERATE(true, false);
    const auto steps = GENERATE(Steps{1, 0}, Steps{0.5, 0}, Steps{0, 1.0 / 3}, Steps{0.3, -0.9}, Steps{2, 3});
    const Grid grid = GENERATE(Grid::of_elements(7, 5, 0.5, 0.3), Grid::of_elements(2, 1, 1, 1),
                               Grid::of_elements(3, 1, 1, 2), Grid::of_elements(3, 2, 2, 1));
    const Exact exact = half_spaces(different, load_shape, grid.dx, grid.dy);
    const IcTable table = sampled(exact, grid.nx, grid.ny, grid.dx, grid.dy);
    const auto nearest = known ? std::optional(HalfSpaces{different, load_shape}) : std::nullopt;
    const double shift_x = steps.x * grid.dx, shift_y = steps.y * grid.dy;
    CAPTURE(int(load_shape), known, steps.x, steps.y);
    CHECK(error(shifted_table(table, nearest, grid, shift_x, shift_y), exact, grid, shift_x, shift_y) <
          (known ? 1e-12 : 1e-9));
}

TEST_CASE("tables of other bodies are interpolated and go on beyond their end", "[shifted]") {
    const double h = 0.5;
    const Grid grid = Grid::of_elements(20, 20, h, h);
    const Exact exact = layer(different, h, h, 2 * h);
    const bool known = GENERATE(true, false);
    const auto nearest = known ? std::optional(HalfSpaces{different, LoadShape::constant}) : std::nullopt;
    const int beyond = GENERATE(0, 3);
    const IcTable table = sampled(exact, 20 + beyond, 20 + beyond, h, h);
    const auto shift_error = [&](double steps_x, double steps_y) {
        return error(shifted_table(table, nearest, grid, steps_x * h, steps_y * h), exact, grid, steps_x * h,
                     steps_y * h);
    };
    CAPTURE(known, beyond);
    const double interpolation = known ? 5e-5 : 4e-4;
    CHECK(shift_error(1, 0) < (beyond ? 1e-15 : 1e-5));
    CHECK(shift_error(0.5, 0) < interpolation);
    CHECK(shift_error(0, 1.0 / 3) < interpolation);
    CHECK(shift_error(0.6, 0.8) < interpolation);
}

TEST_CASE("roughness of a computed table does not grow", "[shifted]") {
    const Grid grid = Grid::of_elements(8, 8, 1, 1);
    const Exact exact = half_spaces(different, LoadShape::constant, 1, 1);
    IcTable table = sampled(exact, 8, 8, 1, 1);
    for (std::size_t i = 0; i < table.values.size(); ++i)
        table.values[i] *= 1 + 1e-4 * std::sin(13.0 * static_cast<double>(i));
    CHECK(error(shifted_table(table, HalfSpaces{different, LoadShape::constant}, grid, 0.5, 0.3), exact, grid, 0.5,
                0.3) < 3e-4);
}

TEST_CASE("the smallest tables can be shifted any distance", "[shifted]") {
    const auto [nx, ny] = GENERATE(std::pair{1, 1}, std::pair{1, 4}, std::pair{2, 1}, std::pair{2, 2});
    const double steps = GENERATE(0.5, 1.0, 40.25, -3000.0);
    const Grid grid = Grid::of_elements(nx, ny, 1, 2);
    const Exact exact = layer(different, 1, 2, 3);
    const ShiftedTable table = shifted_table(sampled(exact, nx, ny, 1, 2), {}, grid, steps, -steps);
    for (const double value : table.values) CHECK(std::abs(value) < 3 * exact(Axis::x, Axis::x, 0, 0));
}

TEST_CASE("a shifted table is cropped around its origin", "[shifted]") {
    const Grid large = Grid::of_elements(6, 5, 1, 2), small = Grid::of_elements(4, 2, 1, 2);
    const HalfSpaces pair{different, LoadShape::constant};
    const ShiftedTable part = cropped(shifted_half_spaces(pair, large, 0.3, 0.1), 4, 2);
    const ShiftedTable own = shifted_half_spaces(pair, small, 0.3, 0.1);
    for (std::size_t i = 0; i < own.values.size(); ++i) CHECK_THAT(part.values[i], WithinAbs(own.values[i], 1e-14));
    CHECK_THROWS_AS(cropped(own, 4, 3), InvalidArgument);
}

TEST_CASE("a shifted table needs a table of the grid's extent", "[shifted]") {
    const Grid grid = Grid::of_elements(3, 3, 1, 1);
    CHECK_THROWS_AS(shifted_table(IcTable(2, 3), {}, grid, 1, 0), InvalidArgument);
    CHECK_THROWS_AS(shifted_table(IcTable(3, 3), {}, grid, NAN, 0), InvalidArgument);
    CHECK_THROWS_AS(shifted_half_spaces({different, LoadShape::constant}, grid, 0, 1e9), InvalidArgument);
}
