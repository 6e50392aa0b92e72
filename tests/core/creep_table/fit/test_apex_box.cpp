#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>

#include "contactd/error.hpp"
#include "creep_table/blended_forces.hpp"

using namespace contactd;
using namespace contactd::creep_table;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double pi = std::numbers::pi;

TableAxes around_the_apex() {
    return {{{0, std::log(3), 8}, {pi / 4, 3 * pi / 4, 8}, {5 * pi / 16, pi / 2, 8}, {0.75, 1.375, 8}}};
}

// Adds a bump of a tenth that the table cannot follow, symmetric in X.
double bump(const std::array<double, 4>& point) {
    double product = 0.1 * (point[0] > 0 ? std::pow(std::sin(point[0]), 2) : 0);
    product *= std::pow(std::sin(2 * (point[1] - pi / 4)), 4);
    product *= std::pow(std::cos(8.0 / 3 * (pi / 2 - point[2])), 4);
    return product * std::pow(std::sin(pi * (point[3] - 0.75) / 0.625), 4);
}

struct Boxed {
    TableAxes box = around_the_apex();
    std::vector<float> coefficients;

    Boxed() {
        const BlendedTable& table = blended_table();
        std::vector<double> nodes;
        for_each_node(box, 0, [&](const std::array<double, 4>& point) {
            const Triple found = evaluate(table.spline(), point[0], creepages_at(table.grid, table.nu, point)).forces;
            for (const double force : found) nodes.push_back(force + bump(point));
        });
        coefficients = fit_apex_box(table.grid, table.coefficients, box, nodes);
    }
};

Triple difference(const std::array<double, 4>& point) {
    static const Boxed boxed;
    const BlendedTable& table = blended_table();
    CreepSpline spline = table.spline();
    const Triple w = creepages_at(table.grid, table.nu, point), plain = evaluate(spline, point[0], w).forces;
    spline.box = boxed.box;
    spline.box_coefficients = boxed.coefficients;
    const Triple found = evaluate(spline, point[0], w).forces;
    return {found[0] - plain[0], found[1] - plain[1], found[2] - plain[2]};
}

}  // namespace

TEST_CASE("a box corrects the table inside", "[creep_table]") {
    const double l = GENERATE(0.3, 0.61, 1.05), a = GENERATE(1.2, 1.7), b = GENERATE(1.2, pi / 2),
                 u_ = GENERATE(1.0, 1.1);
    const Triple found = difference({l, a, b, u_});
    const double expected = bump({l, a, b, u_});
    if (b == pi / 2) CHECK(found[0] == 0);
    CHECK_THAT(found[1], WithinAbs(expected, 0.05 * 0.1));
    CHECK_THAT(found[2], WithinAbs(expected, 0.05 * 0.1));
}

TEST_CASE("a box vanishes smoothly at its faces inside the table", "[creep_table]") {
    const double in = 1e-3;
    const std::array<double, 4> point =
        GENERATE_COPY(std::array{in, 1.5, 1.4, 1.1}, std::array{0.9, pi / 4 + in, 1.4, 1.1},
                      std::array{0.9, 1.5, 5 * pi / 16 + in, 1.1}, std::array{0.9, 1.5, 1.4, 0.75 + in},
                      std::array{0.9, 1.5, 1.4, 1.375 - in}, std::array{-0.1, 1.5, 1.4, 1.1});
    for (const double value : difference(point)) CHECK_THAT(value, WithinAbs(0, 2e-5));
}

TEST_CASE("a box must lie inside its table", "[creep_table]") {
    const CreepGrid& grid = blended_table().grid;
    CHECK(is_inside(around_the_apex(), grid));
    TableAxes box = around_the_apex();
    box[GENERATE(0, 1, 2, 3)].to = 4;
    CHECK_FALSE(is_inside(box, grid));
    box = around_the_apex();
    box[u].from = 0;
    CHECK_FALSE(is_inside(box, grid));
}

TEST_CASE("the box of a table lies around the apex, on its nodes", "[creep_table]") {
    const CreepGrid grid = creep_grid(0.05, 20, {32, 40, 16, 32});
    const TableAxes box = apex_box(grid).value();
    CHECK(is_inside(box, grid));
    const std::array<double, 4> apex{std::log(8), pi / 2, pi / 2, 1};
    for (int axis = 0; axis < axis_count; ++axis) {
        CHECK(box[axis].contains(apex[axis]));
        const double cells = (box[axis].from - grid.axes[axis].from) / grid.axes[axis].step();
        CHECK_THAT(cells, WithinAbs(std::round(cells), 1e-9));
        const double finer = grid.axes[axis].step() / box[axis].step();
        CHECK_THAT(finer, WithinAbs(axis == log_ratio ? 1 : 2, 1e-9));
    }
    CHECK(std::exp(box[log_ratio].from) <= 2);
    CHECK(is_inside(apex_box(creep_grid(3, 20, {4, 5, 4, 4})).value(), creep_grid(3, 20, {4, 5, 4, 4})));
    CHECK_FALSE(apex_box(creep_grid(0.05, 2, {32, 40, 16, 32})));
}
