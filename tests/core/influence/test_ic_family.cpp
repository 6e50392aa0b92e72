// Tests interpolation between tables of several Poisson's ratios.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "contactd/ic_family.hpp"
#include "contactd/ic_record.hpp"
#include "half_space_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// Creates tables of 3 x 2 offsets that are the half-space's with one entry replaced by f(nu).
std::vector<IcTable> family_with(int n, Axis i, Axis j, int k, int l, const std::function<double(double)>& f) {
    std::vector<IcTable> family;
    for (const double nu : family_points(n)) {
        family.push_back(half_space_table(analytic({1, nu}, 1, 0.5, 3, 2)));
        family.back()(i, j, k, l) = f(nu);
    }
    return family;
}

double at(const std::vector<IcTable>& family, double nu) {
    return interpolated(family, nu)(Axis::z, Axis::z, 1, 1);
}

}  // namespace

TEST_CASE("the points of a family rise from 0 to 0.49 in two halves and hold those of the coarser family",
          "[ic_family]") {
    const std::vector<double> coarse = family_points(5), fine = family_points(9);
    REQUIRE(coarse.size() == 10);
    REQUIRE(fine.size() == 18);
    CHECK(fine.front() == 0);
    CHECK(fine.back() == largest_family_nu);
    CHECK(fine[8] == family_break);
    CHECK(fine[9] == family_break);
    CHECK(std::is_sorted(fine.begin(), fine.end()));
    for (std::size_t half = 0; half < 2; ++half)
        for (std::size_t j = 0; j < 5; ++j) CHECK(fine[9 * half + 2 * j] == coarse[5 * half + j]);
    CHECK_THAT(family_points(4)[1], WithinRel(family_break / 4, 1e-15));
    CHECK_THROWS_AS(family_points(1), InvalidArgument);
}

TEST_CASE("Poisson's ratios that are told apart by rounding only belong to the same half", "[ic_family]") {
    // Both halves of an accuracy have their own meshes.
    std::vector<IcTable> family = family_with(5, Axis::z, Axis::z, 1, 1, [](double) { return 1; });
    for (std::size_t j = 5; j < family.size(); ++j) family[j](Axis::z, Axis::z, 1, 1) = 2;
    CHECK(at(family, 0.3) == at(family, 0.1 + 0.2));
    CHECK_THAT(at(family, 0.31), WithinRel(2.0, 1e-12));
}

TEST_CASE("n tables reproduce polynomials of degree n - 1", "[ic_family]") {
    const int n = GENERATE(2, 3, 5, 6, 9, 17);
    const auto polynomial = [&](double nu) {
        double value = 0;
        for (int k = 0; k < n; ++k) value = value * (4 * nu - 1) + 1 + 0.3 * k;
        return value;
    };
    const auto family = family_with(n, Axis::z, Axis::z, 1, 1, polynomial);
    for (const double nu : {1e-13, 0.01, 0.123, 0.245 + 1e-15, 0.3, 0.48999999})
        CHECK_THAT(at(family, nu), WithinRel(polynomial(nu), 1e-12));
}

TEST_CASE("the halves do not know of each other", "[ic_family]") {
    // Each half of an accuracy has a table at the break, on its own mesh.
    auto family = family_with(3, Axis::z, Axis::z, 1, 1, [](double) { return 1; });
    for (std::size_t j = 3; j < family.size(); ++j) family[j](Axis::z, Axis::z, 1, 1) = 2;
    CHECK_THAT(at(family, 0.29), WithinRel(1, 1e-14));
    CHECK_THAT(at(family, family_break), WithinRel(1, 1e-14));
    CHECK_THAT(at(family, 0.31), WithinRel(2, 1e-14));
}

TEST_CASE("the closed form, linear in nu, is interpolated exactly", "[ic_family]") {
    std::vector<IcTable> family;
    for (const double nu : family_points(3)) family.push_back(half_space_table(analytic({1, nu}, 1, 0.5, 4, 3)));
    const IcTable expected = half_space_table(analytic({1, 0.37}, 1, 0.5, 4, 3));
    const IcTable table = interpolated(family, 0.37);
    REQUIRE(table.nx == 4);
    REQUIRE(table.ny == 3);
    for (std::size_t i = 0; i < table.values.size(); ++i)
        CHECK_THAT(table.values[i], WithinAbs(expected.values[i], 1e-15));
}

TEST_CASE("at the Poisson's ratio of a table the answer is that table", "[ic_family]") {
    const auto family = family_with(5, Axis::z, Axis::z, 1, 1, [](double nu) { return std::exp(7 * nu); });
    const std::vector<double> points = family_points(5);
    for (std::size_t j = 0; j < points.size(); ++j) CHECK(interpolated(family, points[j]).values == family[j].values);
}

TEST_CASE("families that cannot be interpolated are refused", "[ic_family]") {
    auto family = family_with(3, Axis::z, Axis::z, 1, 1, [](double nu) { return 1 + nu; });
    for (const double nu : {-1e-9, 0.4901, 0.5, std::numeric_limits<double>::quiet_NaN()}) {
        try {
            interpolated(family, nu);
            FAIL("nu = " << nu << " was accepted");
        } catch (const InvalidArgument& error) {
            CHECK(error.field() == "material.nu");
        }
    }
    CHECK_THROWS_AS(interpolated({family[0]}, 0.3), InvalidArgument);
    family[1] = cropped(family[1], 2, 2);
    CHECK_THROWS_AS(interpolated(family, 0.3), InvalidArgument);
}

TEST_CASE("the estimate bounds the error of interpolation", "[ic_family]") {
    struct Case {
        const char* name;
        std::function<double(double)> f;
        double generous;  // factor by which the estimate may exceed the error
    };
    const auto& [name, f, generous] = GENERATE(values<Case>({
        {"1/(0.55-nu)", [](double nu) { return 1 / (0.55 - nu); }, 4},
        {"1/(0.51-nu)", [](double nu) { return 1 / (0.51 - nu); }, 4},
        {"locking", [](double nu) { return 1 - 0.9 * nu + 1e-3 / (0.5 - nu); }, 4},
        {"exp", [](double nu) { return std::exp(3 * nu); }, 1000},
        {"odd", [](double nu) { return 2 + std::sinh(4 * (nu - 0.245)); }, 1000},
    }));
    const int n = GENERATE(4, 5, 8);
    const auto family = family_with(n, Axis::z, Axis::z, 1, 1, f);
    double error = 0;
    for (double nu = 0; nu <= 0.49; nu += 0.001) error = std::max(error, std::abs(at(family, nu) / f(nu) - 1));

    const double estimate = interpolation_error(analytic({1, 0}, 1, 0.5, 3, 2), family);

    // Errors are relative to the local value, and the estimate to the smallest one, which may add a factor.
    CAPTURE(name, n, error, estimate);
    const double spread = std::max(f(0), f(0.49)) / std::min(f(0), f(0.49));
    CHECK(estimate >= error);
    CHECK(estimate <= generous * spread * error);
}

TEST_CASE("components that keep their sign are measured relative to their values", "[ic_family]") {
    const IcSpec spec = analytic({1, 0}, 1, 0.5, 3, 2);
    const auto estimate = [&](double factor) {
        const auto f = [&](double nu) { return factor / (0.55 - nu); };
        return interpolation_error(spec, family_with(5, Axis::x, Axis::x, 2, 1, f));
    };
    CHECK_THAT(estimate(1e-3), WithinRel(estimate(1), 1e-9));
}

TEST_CASE("components that change sign are measured by the distance", "[ic_family]") {
    const IcSpec spec = analytic({1, 0}, 1, 0.5, 3, 2);
    const auto bent = [](double nu) { return std::pow(nu, 4); };
    const auto estimate = [&](Axis i, Axis j, int k, int l) {
        return interpolation_error(spec, family_with(5, i, j, k, l, bent));
    };
    const double along_x = estimate(Axis::x, Axis::y, 2, 0);
    CHECK(along_x > 0);
    CHECK_THAT(estimate(Axis::z, Axis::y, 2, 1) / along_x, WithinRel(std::hypot(2, 0.5) / 2, 1e-12));
}

TEST_CASE("the origin of components that are zero there does not count", "[ic_family]") {
    const auto family = family_with(5, Axis::x, Axis::z, 0, 0, [](double nu) { return std::exp(20 * nu); });
    CHECK(interpolation_error(analytic({1, 0}, 1, 0.5, 3, 2), family) < 1e-13);
}

TEST_CASE("a record answers for its own Poisson's ratio or for any of its family", "[ic_family]") {
    IcRecord record;
    record.spec = analytic({1, 0.3}, 1, 0.5, 3, 2);
    record.tables = half_space_table(record.spec);
    CHECK(table_for(record, record.spec).values == record.table().values);

    record.spec.any_nu = true;
    record.tables = IcFamily{family_with(5, Axis::z, Axis::z, 1, 1, [](double nu) { return 1 + nu * nu; })};
    record.evidence.family_nu = family_points(5);
    IcSpec request = record.spec;
    request.material = {4, 0.4};
    CHECK_THAT(table_for(record, request)(Axis::z, Axis::z, 1, 1), WithinRel(1.16 / 4, 1e-14));
    request.nx = 2;
    CHECK(table_for(record, request).nx == 2);

    record.evidence.family_nu[1] += 0.01;
    CHECK_THROWS_AS(table_for(record, request), StoreError);
}
