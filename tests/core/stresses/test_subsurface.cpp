#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

#include "contact/contact_cases.hpp"
#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "contactd/subsurface.hpp"
#include "influence/quadrature.hpp"
#include "point_stresses.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using Point = std::array<double, 3>;

std::array<double, 6> stress_at(const SubsurfaceStress& s, std::size_t i) {
    return {s.xx[i], s.yy[i], s.zz[i], s.xy[i], s.xz[i], s.yz[i]};
}

// Applies a unit traction on the only element.
SurfaceTractions unit_traction(Axis load) {
    SurfaceTractions tractions;
    (load == Axis::x ? tractions.x : load == Axis::y ? tractions.y : tractions.z) = {1};
    return tractions;
}

std::array<double, 6> below_element(Axis load, double dx, double dy, const Point& point, double nu) {
    Observer observer;
    return stress_at(subsurface_stress(Grid::of_elements(1, 1, dx, dy), unit_traction(load), nu,
                                       std::vector<Point>{point}, observer),
                     0);
}

std::vector<Point> points_of(const StressBlock& block) {
    std::vector<Point> points;
    for (const double z : block.z)
        for (const double y : block.y)
            for (const double x : block.x) points.push_back({x, y, z});
    return points;
}

void check_equal(const SubsurfaceStress& a, const SubsurfaceStress& b, double tolerance) {
    REQUIRE(a.xx.size() == b.xx.size());
    for (std::size_t i = 0; i < a.xx.size(); ++i) {
        CAPTURE(i);
        for (std::size_t c = 0; c < 6; ++c) CHECK_THAT(stress_at(a, i)[c], WithinAbs(stress_at(b, i)[c], tolerance));
    }
}

}  // namespace

TEST_CASE("stresses below an element are the sum of those below point forces", "[subsurface]") {
    const Axis load = GENERATE(Axis::x, Axis::y, Axis::z);
    const double nu = GENERATE(0.0, 0.3, 0.5);
    const double dx = 0.7, dy = 1.1;
    for (const Point& p : {Point{0.1, 0.2, -0.4},
                           {-0.9, 0.3, -0.2},
                           {0.35, -0.55, -0.3},
                           {0.2, -2, -1.5},
                           {-3, -2, -0.1},
                           {0, 0, -6},
                           {5, 4, -0.05}}) {
        const auto computed = below_element(load, dx, dy, p, nu);
        for (std::size_t c = 0; c < 6; ++c) {
            CAPTURE(int(load), nu, p[0], p[1], p[2], c);
            const auto kernel = [&](double X, double Y) { return point_stress(load, X, Y, -p[2], nu)[c]; };
            const double expected = adaptive(kernel, p[0] - dx / 2, p[0] + dx / 2, p[1] - dy / 2, p[1] + dy / 2, 1e-11);
            CHECK_THAT(computed[c], WithinAbs(expected, 1e-9));
        }
    }
}

TEST_CASE("far below, an element is a point force", "[subsurface]") {
    const Axis load = GENERATE(Axis::x, Axis::y, Axis::z);
    const Point p{300, -200, -250};
    const auto computed = below_element(load, 0.5, 0.5, p, 0.25);
    const auto expected = point_stress(load, p[0], p[1], -p[2], 0.25);
    for (std::size_t c = 0; c < 6; ++c) CHECK_THAT(computed[c], WithinAbs(0.25 * expected[c], 1e-12));
}

TEST_CASE("at the surface the stresses are the tractions", "[subsurface]") {
    const Grid grid = Grid::of_elements(5, 4, 1, 0.6);
    const SurfaceTractions tractions{random_values(20, 1), random_values(20, 2), random_values(20, 3)};
    const double depth = GENERATE(0.0, 1e-9);
    std::vector<Point> points;
    for (int iy = 0; iy < 4; ++iy)
        for (int ix = 0; ix < 5; ++ix) points.push_back({grid.x(ix) + 0.2, grid.y(iy) - 0.1, -depth});
    points.push_back({4, 0, -depth});
    Observer observer;
    const auto stress = subsurface_stress(grid, tractions, 0.3, points, observer);
    for (std::size_t e = 0; e < 20; ++e) {
        CHECK_THAT(stress.zz[e], WithinAbs(tractions.z[e], 1e-7));
        CHECK_THAT(stress.xz[e], WithinAbs(tractions.x[e], 1e-7));
        CHECK_THAT(stress.yz[e], WithinAbs(tractions.y[e], 1e-7));
    }
    for (const auto* values : {&stress.zz, &stress.xz, &stress.yz}) CHECK_THAT((*values)[20], WithinAbs(0, 1e-7));
}

TEST_CASE("at edges and corners stresses are means and finite", "[subsurface]") {
    const Axis load = GENERATE(Axis::x, Axis::y, Axis::z);
    const auto own = [&](const std::array<double, 6>& s) { return s[load == Axis::z ? 2 : load == Axis::x ? 4 : 5]; };
    CHECK_THAT(own(below_element(load, 0.6, 0.2, {0.3, 0.03, 0}, 0.3)), WithinAbs(0.5, 1e-12));
    CHECK_THAT(own(below_element(load, 0.6, 0.2, {-0.1, -0.1, 0}, 0.3)), WithinAbs(0.5, 1e-12));
    CHECK_THAT(own(below_element(load, 0.6, 0.2, {0.3, -0.1, 0}, 0.3)), WithinAbs(0.25, 1e-12));
    for (const Point& p : {Point{0.3, 0.03, 0}, {-0.3, 0.1, 0}, {0.1, 0.1, 0}, {0.3, 5, 0}, {0.3, -5, 0}, {7, 0.1, 0}})
        for (const double value : below_element(load, 0.6, 0.2, p, 0.3)) CHECK(std::abs(value) < 20);
}

TEST_CASE("edges between equal tractions do not show", "[subsurface]") {
    Observer observer;
    const std::array<Point, 2> points{Point{0, 0.1, 0}, {0, 0, -1e-12}};
    const Values equal(16, 0.7);
    const auto many = subsurface_stress(Grid::of_elements(4, 4, 1, 1), {equal, equal, equal}, 0.3, points, observer);
    const auto one = subsurface_stress(Grid::of_elements(1, 1, 4, 4), {{0.7}, {0.7}, {0.7}}, 0.3, points, observer);
    check_equal(many, one, 1e-12);
}

TEST_CASE("blocks hold the stresses of their points", "[subsurface]") {
    const Grid grid{9, 7, 0.5, 0.8, -1, 3};
    const std::size_t n = grid.size();
    Values x = random_values(n, 1), y = random_values(n, 2), z = random_values(n, 3);
    if (GENERATE(false, true))  // a contact smaller than the grid
        for (std::size_t e = 0; e < n; ++e)
            if (e % 9 < 2 || e / 9 < 1 || e / 9 > 4) x[e] = y[e] = z[e] = 0;
    StressBlock block;
    block.z = {-0.3, 0, -2.5};
    SECTION("at the element centres") {
        for (int ix = 0; ix < 9; ++ix) block.x.push_back(grid.x(ix));
        for (int iy = 0; iy < 7; ++iy) block.y.push_back(grid.y(iy));
    }
    SECTION("wider than the grid, twice as fine, beginning on edges") {
        for (int ix = -6; ix < 30; ++ix) block.x.push_back(grid.x0 + 0.25 * ix);
        for (int iy = -3; iy < 20; ++iy) block.y.push_back(grid.y0 + 0.4 * iy);
    }
    SECTION("beside the grid, every second element, backwards") {
        for (int ix = 20; ix > 0; --ix) block.x.push_back(grid.x0 + 7 + ix * 1.0 + 0.1);
        for (int iy = 0; iy < 12; ++iy) block.y.push_back(grid.y(iy) - 20);
    }
    SECTION("a few that would span a raster too large") {
        block.x = {grid.x(0), grid.x(0) + 0.5 * 900'000};
        block.y = {3.3};
    }
    SECTION("anywhere") {
        block.x = {-7, 0.123, 0.7, 1e7};
        block.y = {3.3};
    }
    Observer observer;
    const auto computed = subsurface_stress(grid, {x, y, z}, 0.28, block, observer);
    const auto expected = subsurface_stress(grid, {x, y, z}, 0.28, points_of(block), observer);
    check_equal(computed, expected, 1e-11);
    CHECK(computed.largest == expected.largest);
}

TEST_CASE("von Mises stress and its largest value are found", "[subsurface]") {
    Observer observer;
    const Grid grid = Grid::of_elements(1, 1, 1, 1);
    const StressBlock block{{0}, {0}, {0, -0.3, -0.6, -2}};
    const auto s = subsurface_stress(grid, {{}, {}, {-5}}, 0.3, block, observer);
    for (std::size_t i = 0; i < 4; ++i)  // on the axis xx = yy, without shear
        CHECK_THAT(s.von_mises[i], WithinRel(std::abs(s.xx[i] - s.zz[i]), 1e-12));
    CHECK(s.largest == 1);
    const auto sheared = subsurface_stress(grid, {{3}, {}, {}}, 0.3, std::vector<Point>{{0, 0, 0}}, observer);
    CHECK_THAT(sheared.von_mises[0], WithinRel(std::sqrt(3.0) * 3, 1e-12));
}

TEST_CASE("tractions on the two bodies are opposite, each in the frame of its body", "[subsurface]") {
    const Values pressure{2}, x{0.3}, y{-0.1};
    const auto upper = tractions_on(ContactBody::upper, pressure, x, y);
    const auto lower = tractions_on(ContactBody::lower, pressure, x, y);
    CHECK(upper.x == x);
    CHECK(upper.y == y);
    CHECK(upper.z == Values{-2});
    CHECK(lower.x == Values{-0.3});
    CHECK(lower.y == Values{0.1});
    CHECK(lower.z == Values{-2});
}

TEST_CASE("without tractions there is no stress", "[subsurface]") {
    Observer observer;
    const auto s = subsurface_stress(Grid::of_elements(3, 3, 1, 1), {{}, Values(9), {}}, 0.3,
                                     StressBlock{{0, 1}, {0}, {0, -1}}, observer);
    CHECK(s.von_mises == Values(4));
}

TEST_CASE("stresses can be watched and cancelled", "[subsurface]") {
    struct Watch : Observer {
        double last = 0;
        int reports = 0;
        int cancel_after = 1000000;
        void on_progress(const Progress& progress) override {
            CHECK(progress.stage == "subsurface");
            CHECK(progress.fraction >= last);
            last = progress.fraction;
            ++reports;
        }
        bool cancelled() const override { return reports >= cancel_after; }
    };
    const Grid grid = Grid::of_elements(30, 30, 1, 1);
    const SurfaceTractions tractions{{}, {}, random_values(900, 1)};
    const std::vector<Point> points(400, Point{0.3, 0.3, -1});
    const StressBlock block{{0, 1.1, 2.3, 3.7}, {0}, Values(100, -1.0)};
    for (const int cancel_after : {1000000, 2}) {
        Watch of_points, of_block;
        of_points.cancel_after = of_block.cancel_after = cancel_after;
        if (cancel_after == 2) {
            CHECK_THROWS_AS(subsurface_stress(grid, tractions, 0.3, points, of_points), Cancelled);
            CHECK_THROWS_AS(subsurface_stress(grid, tractions, 0.3, block, of_block), Cancelled);
        } else {
            subsurface_stress(grid, tractions, 0.3, points, of_points);
            subsurface_stress(grid, tractions, 0.3, block, of_block);
            CHECK(of_points.last == 1);
            CHECK(of_block.last == 1);
            CHECK(of_block.reports > 2);
        }
    }
}

TEST_CASE("impossible requests for stresses are refused", "[subsurface]") {
    Observer observer;
    const Grid grid = Grid::of_elements(2, 1, 1, 1);
    const SurfaceTractions tractions{{}, {}, {1, 2}};
    const auto field_of = [&](const SurfaceTractions& given, double nu, const StressBlock& block) -> std::string {
        try {
            subsurface_stress(grid, given, nu, block, observer);
        } catch (const InvalidArgument& error) {
            return error.field();
        }
        return "";
    };
    const StressBlock block{{0}, {0}, {-1}};
    CHECK(field_of(tractions, 0.3, block).empty());
    CHECK(field_of(tractions, 0.6, block) == "nu");
    CHECK(field_of({{}, {1}, {}}, 0.3, block) == "tractions.y");
    CHECK(field_of({{NAN, 1}, {}, {}}, 0.3, block) == "tractions.x");
    CHECK(field_of(tractions, 0.3, {{0}, {}, {-1}}) == "block.y");
    CHECK(field_of(tractions, 0.3, {{INFINITY}, {0}, {-1}}) == "block.x");
    CHECK(field_of(tractions, 0.3, {{0}, {0}, {0.1}}) == "block.z");
    CHECK_THROWS_AS(subsurface_stress(grid, tractions, 0.3, std::vector<Point>{}, observer), InvalidArgument);
    CHECK_THROWS_AS(subsurface_stress(grid, tractions, 0.3, std::vector<Point>{{0, 0, 1}}, observer), InvalidArgument);
}

TEST_CASE("Principal stresses are those of the tensor, and Tresca's is what they differ by", "[subsurface]") {
    SubsurfaceStress stress;
    stress.xx = {3, -1, 0, 5};
    stress.yy = {3, -1, 0, -2};
    stress.zz = {3, -1, 0, 1};
    stress.xy = {0, 0, 2, 0};
    stress.xz = {0, 0, 0, 0};
    stress.yz = {0, 0, 0, 0};
    find_invariants(stress);
    CHECK(stress.hydrostatic == Values{3, -1, 0, 4. / 3});
    for (const std::size_t equal : {0, 1}) CHECK_THAT(stress.tresca[equal], WithinAbs(0, 1e-14));
    CHECK_THAT(stress.principal_1[2], WithinAbs(2, 1e-14));
    CHECK_THAT(stress.principal_2[2], WithinAbs(0, 1e-14));
    CHECK_THAT(stress.principal_3[2], WithinAbs(-2, 1e-14));
    CHECK_THAT(stress.tresca[2], WithinAbs(4, 1e-14));
    CHECK_THAT(stress.principal_1[3], WithinAbs(5, 1e-14));
    CHECK_THAT(stress.principal_2[3], WithinAbs(1, 1e-14));
    CHECK_THAT(stress.principal_3[3], WithinAbs(-2, 1e-14));
}

TEST_CASE("Displacements inside agree with quadrature of point forces", "[subsurface]") {
    const double nu = GENERATE(0.0, 0.28, 0.5), dx = 0.5, dy = 0.8;
    const Material material{70, nu};
    const IcSpec spec{{}, material, dx, dy, 1, 1};
    Observer observer;
    for (const Axis load : {Axis::x, Axis::y, Axis::z})
        for (const Point& point :
             {Point{0, 0, -2}, {1, -2, -1.5}, {-3, 0, 0}, {0, 2.5, -0.1}, {-2, -2, 0}, {6, 4, -3}}) {
            CAPTURE(nu, int(load), point);
            const auto expected = half_space_displacement(spec, load, point);
            const auto found = subsurface_displacement(Grid::of_elements(1, 1, dx, dy), unit_traction(load), material,
                                                       StressPoints{point}, observer);
            const double largest = dx * dy / (4 * 3.14 * 70 * 2);
            CHECK_THAT(found.x[0], WithinAbs(expected[0], 1e-6 * largest));
            CHECK_THAT(found.y[0], WithinAbs(expected[1], 1e-6 * largest));
            CHECK_THAT(found.z[0], WithinAbs(expected[2], 1e-6 * largest));
        }
}

TEST_CASE("On the surface displacements are the influence coefficients", "[subsurface]") {
    const Material material{70, 0.28};
    const double dx = 0.5, dy = 0.8;
    Observer observer;
    const StressBlock block{{-1, 0, 0.5}, {-0.8, 0, 1.6}, {0}};
    for (const Axis load : {Axis::x, Axis::y, Axis::z}) {
        const auto found =
            subsurface_displacement(Grid::of_elements(1, 1, dx, dy), unit_traction(load), material, block, observer);
        const std::array<const Values*, 3> components{&found.x, &found.y, &found.z};
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i < 3; ++i)
                for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
                    CAPTURE(int(load), int(axis), block.x[i], block.y[j]);
                    CHECK_THAT(
                        (*components[static_cast<std::size_t>(axis)])[j * 3 + i],
                        WithinAbs(half_space_coefficient(axis, load, block.x[i], block.y[j], dx, dy, material), 1e-12));
                }
    }
}

TEST_CASE("Displacements on a block are those of its points", "[subsurface]") {
    const Grid grid = Grid::of_elements(6, 5, 0.5, 0.8);
    const SurfaceTractions tractions{random_values(30, 1), random_values(30, 2), random_values(30, 3)};
    const Material material{70, 0.28};
    StressBlock block{{}, {-0.8, 0, 0.8, 1.7}, {0, -0.3, -2}};
    for (int i = 0; i < 40; ++i) block.x.push_back(grid.x(0) + 0.25 * i);
    Observer observer;
    const auto on_block = subsurface_displacement(grid, tractions, material, block, observer);
    const auto at_points = subsurface_displacement(grid, tractions, material, StressPoints(points_of(block)), observer);
    for (std::size_t i = 0; i < on_block.x.size(); ++i) {
        CHECK_THAT(on_block.x[i], WithinAbs(at_points.x[i], 1e-12));
        CHECK_THAT(on_block.y[i], WithinAbs(at_points.y[i], 1e-12));
        CHECK_THAT(on_block.z[i], WithinAbs(at_points.z[i], 1e-12));
    }
}
