// Tests coefficients of rolling half-spaces of the standard linear solid.
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "influence/viscoelastic/delayed_integrals.hpp"
#include "influence/viscoelastic/rolling_table.hpp"

using namespace contactd;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr Material nylon{1143, 0.4};
constexpr double V = 1000;

Body solid(const Material& material, double f, double tau, const Ics& ics = {}) {
    return {material, ics, Viscoelasticity{f, tau}};
}

RollingHalfSpaces alike(double f, double tau) {
    return {{solid(nylon, f, tau), solid(nylon, f, tau)}, V};
}

/// Adaptive Simpson's rule.
double integral(const std::function<double(double)>& g, double a, double b, double fa, double fm, double fb,
                double tolerance, int depth) {
    const double m = 0.5 * (a + b), fl = g(0.5 * (a + m)), fr = g(0.5 * (m + b));
    const double whole = (b - a) / 6 * (fa + 4 * fm + fb), halves = (b - a) / 12 * (fa + 4 * fl + 2 * fm + 4 * fr + fb);
    if (depth == 0 || std::abs(halves - whole) < 15 * tolerance) return halves + (halves - whole) / 15;
    return integral(g, a, m, fa, fl, fm, tolerance / 2, depth - 1) +
           integral(g, m, b, fm, fr, fb, tolerance / 2, depth - 1);
}

/// Computes the delayed coefficient of one body by quadrature in t = exp(-s/l), whose weight is one.
double delayed(Axis i, Axis j, double x, double y, const Grid& grid, const Material& body, double l) {
    const auto at = [&](double s) { return half_space_coefficient(i, j, x + s, y, grid.dx, grid.dy, body); };
    double sum = 0, from = 0;
    const auto weighted = [&](double s) { return at(s) * std::exp(-s / l) / l; };
    // Pieces end where the kernel is not smooth, and grow beyond.
    for (double to = std::min(grid.dx, l) / 4; from < 40 * l;) {
        for (const double edge : {-0.5 * grid.dx - x, 0.5 * grid.dx - x})
            if (edge > from + 1e-9 * grid.dx && edge < to) to = edge;
        const double m = 0.5 * (from + to);
        sum += integral(weighted, from, to, weighted(from), weighted(m), weighted(to), 1e-17, 40);
        from = to;
        to = from + std::min(l, std::max(std::min(grid.dx, l) / 4, 0.3 * std::abs(x + from)));
    }
    return sum;
}

}  // namespace

TEST_CASE("delayed coefficients of a given case have their values", "[viscoelastic]") {
    const Grid grid = Grid::of_elements(99, 1, 0.16, 1000);
    const RollingTable rolls = rolling_table(alike(1, 0.009), grid), elastic = rolling_table(alike(0, 0.009), grid);
    const auto E = [&](int k) { return rolls(Axis::z, Axis::z, k, 0) - elastic(Axis::z, Axis::z, k, 0); };
    CHECK_THAT(E(-5), WithinRel(2.9556066869e-4, 1e-10));
    CHECK_THAT(E(0), WithinRel(2.8273694462e-4, 1e-10));
    CHECK_THAT(E(7), WithinRel(2.6476312189e-4, 1e-10));
}

TEST_CASE("delayed coefficients agree with quadrature", "[viscoelastic]") {
    const double aspect = GENERATE(1.0, 0.05, 30.0), l = GENERATE(0.02, 0.3, 5.0);
    CAPTURE(aspect, l);
    const Grid grid = Grid::of_elements(4, 3, 0.3, 0.3 * aspect);
    const RollingHalfSpaces below{{{Material::rigid()}, solid(nylon, 1, l / V)}, V};
    const RollingHalfSpaces elastic{{{Material::rigid()}, solid(nylon, 0, l / V)}, V};
    const RollingTable rolls = rolling_table(below, grid), at_once = rolling_table(elastic, grid);
    const double scale = at_once(Axis::z, Axis::z, 0, 0);
    for (const Axis i : {Axis::x, Axis::y, Axis::z})
        for (const Axis j : {Axis::x, Axis::y, Axis::z})
            for (const int k : {-3, -1, 0, 2})
                for (const int m : {-2, 0, 1}) {
                    const double x = k * grid.dx, y = m * grid.dy;
                    CAPTURE(i, j, k, m);
                    CHECK_THAT(at_once(i, j, k, m),
                               WithinAbs(half_space_coefficient(i, j, x, y, grid.dx, grid.dy, nylon), 1e-12 * scale));
                    CHECK_THAT(rolls(i, j, k, m) - at_once(i, j, k, m),
                               WithinAbs(delayed(i, j, x, y, grid, nylon, l), 2e-11 * scale));
                }
}

TEST_CASE("delayed coefficients follow those at once at the rate of creep", "[viscoelastic]") {
    const LoadShape shape = GENERATE(LoadShape::constant, LoadShape::bilinear);
    const bool line = GENERATE(false, true);
    CAPTURE(shape, line);
    Ics ics;
    ics.load_shape = shape;
    if (line) ics.line_contact = LineContactSpec{50};
    const double tau = 1e-3, l = V * tau, step = 1e-3;
    const Grid grid = Grid::of_elements(5, line ? 1 : 3, 0.4, 0.3);
    const auto rolling = [&](double f) {
        return RollingHalfSpaces{{{Material::rigid()}, solid(nylon, f, tau, ics)}, V};
    };
    const auto E = [&](double ahead) {
        ShiftedTable with = rolling_table_ahead(rolling(1), grid, ahead),
                     without = rolling_table_ahead(rolling(0), grid, ahead);
        for (std::size_t at = 0; at < with.values.size(); ++at) with.values[at] -= without.values[at];
        return with;
    };
    // Checks E - l dE/dd = A, by differences at a point away from the edges of the load.
    const double place = 0.13;
    const ShiftedTable now = E(place), ahead = E(place + step), behind = E(place - step), ahead2 = E(place + 2 * step),
                       behind2 = E(place - 2 * step), A = rolling_table_ahead(rolling(0), grid, place);
    double largest = 0;
    for (const double value : A.values) largest = std::max(largest, std::abs(value));
    for (std::size_t at = 0; at < A.values.size(); ++at) {
        const double slope =
            (8 * (ahead.values[at] - behind.values[at]) - (ahead2.values[at] - behind2.values[at])) / (12 * step);
        CHECK_THAT(now.values[at] - l * slope, WithinAbs(A.values[at], 1e-8 * largest));
    }
}

TEST_CASE("creep that is fast or slow is none", "[viscoelastic]") {
    const Grid grid = Grid::of_elements(6, 4, 0.5, 0.7);
    const RollingTable elastic = rolling_table(alike(0, 1), grid);
    const double scale = elastic(Axis::z, Axis::z, 0, 0), f = 2.5;
    const RollingTable fast = rolling_table(alike(f, 1e-6 * grid.dx / V), grid),
                       at_once = rolling_table(alike(f, 1e-200), grid), slow = rolling_table(alike(f, 1e9 / V), grid);
    for (std::size_t at = 0; at < elastic.values.size(); ++at) {
        CHECK_THAT(fast.values[at], WithinAbs((1 + f) * elastic.values[at], 1e-5 * scale));
        CHECK_THAT(at_once.values[at], WithinAbs((1 + f) * elastic.values[at], 1e-12 * scale));
        CHECK_THAT(slow.values[at], WithinAbs(elastic.values[at], 1e-7 * scale));
    }
}

TEST_CASE("rolling the other way mirrors the coefficients", "[viscoelastic]") {
    const Grid grid = Grid::of_elements(5, 3, 0.5, 0.7);
    RollingHalfSpaces bodies{{solid(nylon, 1, 2e-3), {{3000, 0.3}}}, V};
    const RollingTable forward = rolling_table(bodies, grid);
    const ShiftedTable ahead = rolling_table_ahead(bodies, grid, 0.3);
    bodies.is_forward = false;
    const RollingTable backward = rolling_table(bodies, grid);
    const ShiftedTable behind = rolling_table_ahead(bodies, grid, 0.3);
    for (const Axis i : {Axis::x, Axis::y, Axis::z})
        for (const Axis j : {Axis::x, Axis::y, Axis::z})
            for (int k = 1 - grid.nx; k < grid.nx; ++k)
                for (int m = 1 - grid.ny; m < grid.ny; ++m) {
                    const double rotated = parity(i, j).along_x;
                    CHECK(backward(i, j, k, m) == rotated * forward(i, j, -k, m));
                    if (i != Axis::z) CHECK(behind(i, j, k, m) == rotated * ahead(i, j, -k, m));
                }
}

TEST_CASE("a step of an element reads the next coefficient", "[viscoelastic]") {
    const Grid grid = Grid::of_elements(5, 3, 0.5, 0.7);
    const RollingHalfSpaces bodies{{solid(nylon, 1, 2e-3), solid({900, 0.2}, 2, 1e-3)}, V};
    const RollingTable now = rolling_table(bodies, Grid::of_elements(6, 3, 0.5, 0.7));
    const ShiftedTable ahead = rolling_table_ahead(bodies, grid, grid.dx);
    const double scale = now(Axis::z, Axis::z, 0, 0);
    for (const Axis i : {Axis::x, Axis::y})
        for (const Axis j : {Axis::x, Axis::y, Axis::z})
            for (int k = 1 - grid.nx; k < grid.nx; ++k)
                for (int m = 1 - grid.ny; m < grid.ny; ++m)
                    CHECK_THAT(ahead(i, j, k, m), WithinAbs(now(i, j, k + 1, m), 1e-12 * scale));
}

TEST_CASE("bodies that creep alike are not coupled, and others are", "[viscoelastic]") {
    const Grid grid = Grid::of_elements(4, 3, 0.5, 0.7);
    const auto coupling = [&](double tau) {
        const RollingTable table = rolling_table({{solid(nylon, 1, 2e-3), solid(nylon, 1, tau)}, V}, grid);
        double largest = 0;
        for (std::size_t at = 0; at < table.component_size(); ++at)
            largest =
                std::max(largest, std::abs(table.values[table.index(Axis::x, Axis::z, 1 - grid.nx, 1 - grid.ny) + at]));
        return largest;
    };
    CHECK(coupling(2e-3) == 0);
    CHECK(coupling(1e-3) > 0);
}

TEST_CASE("rolling tables end when they are cancelled", "[viscoelastic]") {
    struct Cancelling final : Observer {
        bool cancelled() const override { return true; }
    } observer;
    CHECK_THROWS_AS(rolling_table(alike(1, 1e-3), Grid::of_elements(4, 4, 1, 1), observer), Cancelled);
}
