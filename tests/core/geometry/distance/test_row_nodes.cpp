#include "geometry/distance/row_nodes.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <limits>

using Catch::Matchers::WithinAbs;
using contactd::geometry::RowNodes;

namespace {

RowNodes::Values at_nodes(const RowNodes& nodes, double (*function)(double)) {
    RowNodes::Values values;
    for (std::size_t j = 0; j < RowNodes::count; ++j) values[j] = function(nodes.x()[j]);
    return values;
}

}  // namespace

TEST_CASE("A wheel's circle is had from eight points of a row") {
    const auto circle = [](double x) { return std::sqrt(460.0 * 460 - x * x); };
    const double x0 = -7.25, dx = 0.5;
    const int n = 30;
    const RowNodes nodes(x0, dx, n);
    const RowNodes::Values values = at_nodes(nodes, circle);
    CHECK(RowNodes::smooth(values, 1e-10));
    std::vector<double> row{7};
    nodes.interpolate(values, row);
    REQUIRE(row.size() == 1 + n);
    CHECK(row[0] == 7);
    for (int i = 0; i < n; ++i) CHECK_THAT(row[static_cast<std::size_t>(i) + 1], WithinAbs(circle(x0 + i * dx), 1e-11));
}

TEST_CASE("Rows with a kink, or where there is nothing, are not smooth") {
    const RowNodes nodes(-5, 0.5, 21);
    CHECK_FALSE(RowNodes::smooth(at_nodes(nodes, [](double x) { return std::abs(x - 0.1); }), 1e-10));
    CHECK_FALSE(RowNodes::smooth(at_nodes(nodes, [](double x) { return x > 4 ? std::nan("") : x; }), 1e-10));
}
