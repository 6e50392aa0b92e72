#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <random>
#include <set>

#include "fem_specs.hpp"
#include "mesh/shells.hpp"

using namespace contactd;
using namespace contactd::fem;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using Point = std::array<double, 3>;

namespace {

IcSpec spec_of(double dx, double dy, double f) {
    IcSpec spec = coarse_spec(3, 3, dx, dy);
    spec.fem.f = f;
    return spec;
}

std::vector<ElementPosition> all_places(const Shells& shells) {
    std::vector<ElementPosition> places;
    const int m = shells.m;
    for (int x = 0; x < m; ++x)
        for (int y = 0; y < m; ++y)
            for (int z = 0; z < m; ++z) places.push_back({0, 0, {x, y, z}});
    for (int layer = 1; layer <= shells.k; ++layer)
        for (int first = 0; first < m; ++first)
            for (int second = 0; second < m; ++second) {
                places.push_back({layer, 0, {0, first, second}});
                places.push_back({layer, 1, {first, 0, second}});
                places.push_back({layer, 2, {first, second, 0}});
            }
    return places;
}

/// Evaluates the trilinear map of an element.
Point mapped(const Shells& shells, const ElementPosition& place, const Point& local) {
    Point result{};
    for (int corner_number = 0; corner_number < 8; ++corner_number) {
        const std::array<int, 3> side{corner_number & 1, corner_number >> 1 & 1, corner_number >> 2 & 1};
        double weight = 1;
        for (std::size_t a = 0; a < 3; ++a) weight *= side[a] ? local[a] : 1 - local[a];
        const Point at = position(shells, corner(shells, place, side));
        for (std::size_t a = 0; a < 3; ++a) result[a] += weight * at[a];
    }
    return result;
}

/// 2 x 2 x 2 Gauss points integrate the Jacobian of a trilinear map exactly.
double volume(const Shells& shells, const ElementPosition& place) {
    double result = 0;
    const double g = 0.5 / std::sqrt(3.0);
    for (int i = 0; i < 8; ++i) {
        const Point at{0.5 + (i & 1 ? g : -g), 0.5 + (i & 2 ? g : -g), 0.5 + (i & 4 ? g : -g)};
        std::array<Point, 3> d;  // has constant derivatives, because the map is linear along each axis
        for (std::size_t a = 0; a < 3; ++a) {
            Point low = at, high = at;
            low[a] = 0;
            high[a] = 1;
            const Point from = mapped(shells, place, low), to = mapped(shells, place, high);
            for (std::size_t b = 0; b < 3; ++b) d[a][b] = to[b] - from[b];
        }
        result +=
            (d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) - d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
             d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0])) /
            8;
    }
    return result;
}

}  // namespace

TEST_CASE("Layers follow the paper's rule and end exactly at L", "[fem][mesh]") {
    const Shells shells = make_shells(paper_spec("paper-test3", 64));
    CHECK(shells.m == 4);
    CHECK(shells.k == 22);
    for (const auto& edge : shells.edge) {
        CHECK(edge.front() == 0.8);
        CHECK(edge.back() == 64);
        for (std::size_t j = 2; j < edge.size(); ++j)
            CHECK_THAT((edge[j] - edge[j - 1]) / (edge[j - 1] - edge[j - 2]), WithinRel(1.2, 1e-9));
    }
}

TEST_CASE("Layers that do not grow are of one thickness", "[fem][mesh]") {
    const Shells shells = make_shells(spec_of(1, 1, 1));
    CHECK(shells.k == 78);  // (40 - 1) / 0.5
    for (std::size_t j = 1; j < shells.edge[0].size(); ++j)
        CHECK_THAT(shells.edge[0][j] - shells.edge[0][j - 1], WithinRel(0.5, 1e-9));
}

TEST_CASE("Oblong elements stretch the box, not the block", "[fem][mesh]") {
    const Shells shells = make_shells(spec_of(4, 1, 1.5));
    CHECK(shells.edge[0].front() == 4);
    CHECK(shells.edge[1].front() == 1);
    CHECK(shells.edge[2].front() == 2);
    for (const auto& edge : shells.edge) CHECK(edge.back() == 160);
}

TEST_CASE("Elements are numbered one by one and fill the block", "[fem][mesh]") {
    const Shells shells = make_shells(spec_of(1, GENERATE(1.0, 0.3), 1.5));
    std::set<int> numbers;
    double sum = 0, smallest = 1e300;
    for (const ElementPosition& place : all_places(shells)) {
        numbers.insert(element_number(shells, place));
        const double own = volume(shells, place);
        sum += own;
        smallest = std::min(smallest, own);
    }
    CHECK(numbers.size() == static_cast<std::size_t>(shells.elements()));
    CHECK(*numbers.begin() == 0);
    CHECK(*numbers.rbegin() == shells.elements() - 1);
    CHECK(smallest > 0);
    CHECK_THAT(sum, WithinRel(40.0 * 40 * 40, 1e-12));
}

TEST_CASE("A surface point is found in its element", "[fem][mesh]") {
    const double dy = GENERATE(1.0, 0.25, 7.0);
    const Shells shells = make_shells(spec_of(1, dy, 1.2));
    const double L = shells.edge[0].back();
    const auto check = [&](double X, double Y) {
        const SurfacePoint point = locate(shells, X, Y);
        const Point back = mapped(shells, point.place, point.local);
        CHECK_THAT(back[0], WithinAbs(X, 1e-13 * L));
        CHECK_THAT(back[1], WithinAbs(Y, 1e-13 * L));
        CHECK(back[2] == 0);
        for (const double local : point.local) CHECK((local >= 0 && local <= 1));
    };
    std::mt19937 random(1);
    std::uniform_real_distribution<double> exponent(-8, 0);
    for (int i = 0; i < 500; ++i) check(L * std::exp(exponent(random)), L * std::exp(exponent(random)));
    for (const double X : {0.0, 0.5, 1.0, 2.0, L})
        for (const double Y : {0.0, 0.5 * dy, dy, 2 * dy, L}) check(X, Y);
}
