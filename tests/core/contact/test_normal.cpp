#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <functional>

#include "contact/normal/normal.hpp"
#include "contact_cases.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

const Material material{200, 0.42};

struct Case {
    Grid grid;
    IcTable table;
    PairOperator influence;

    explicit Case(const Grid& grid_)
        : grid(grid_), table(half_space_pair(grid, material)), influence(table, grid.nx, grid.ny) {}

    Values gap(const std::function<double(double, double)>& h) const {
        Values values;
        for (int iy = 0; iy < grid.ny; ++iy)
            for (int ix = 0; ix < grid.nx; ++ix) values.push_back(h(grid.x(ix), grid.y(iy)));
        return values;
    }

    NormalSolution solve(const Values& gap, const Values& initial = {}, const SolverSettings& settings = {}) const {
        Observer observer;
        return solve_normal(influence, gap, settings, initial, observer);
    }
};

// Checks section 4.1's conditions, with displacements from dense sums.
int check_contact_conditions(const Case& problem, const Values& h, const NormalSolution& solution) {
    REQUIRE(solution.evidence.converged);
    const auto& p = solution.pressure;
    const Values u = dense_product(problem.table, Axis::z, Axis::z, problem.grid.nx, problem.grid.ny, p);
    double defect = 0, reference = 0;
    int elements = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double gap = u[i] + h[i];
        CHECK(p[i] >= 0);
        if (p[i] > 0) {
            ++elements;
            defect += gap * gap;
            reference += h[i] * h[i];
        } else {
            CHECK(gap >= -1e-12 * std::abs(h[i]));
        }
    }
    CHECK(defect <= 1.001e-12 * reference);
    return elements;
}

double sphere(double x, double y) {
    return (x * x + y * y) / 100;
}

}  // namespace

TEST_CASE("contact conditions hold for many shapes", "[normal]") {
    const auto [nx, ny, aspect] =
        GENERATE(std::tuple{17, 13, 1.0}, std::tuple{1, 31, 1.0}, std::tuple{24, 9, 0.1}, std::tuple{21, 22, 7.0});
    const Case problem(Grid::of_elements(nx, ny, 2.4 / nx, 2.4 / nx / aspect));
    const double R = nx < ny ? 1 : problem.grid.ny * problem.grid.dy / 2.4;
    SECTION("sphere") {
        const Values h = problem.gap([&](double x, double y) { return sphere(x, y / R) - 0.01; });
        CHECK(check_contact_conditions(problem, h, problem.solve(h)) > 0);
    }
    SECTION("two bumps of different height") {
        const Values h = problem.gap([&](double x, double y) {
            return std::min(sphere(x - 0.6, y / R), sphere(x + 0.6, y / R) + 0.001) - 0.003;
        });
        check_contact_conditions(problem, h, problem.solve(h));
    }
    SECTION("roughness") {
        const Values h = random_values(problem.influence.size(), 5, -0.02, 0.02);
        CHECK(check_contact_conditions(problem, h, problem.solve(h)) > 0);
    }
    SECTION("flat punch over the whole window") {
        const Values h(problem.influence.size(), -0.01);
        CHECK(check_contact_conditions(problem, h, problem.solve(h)) == nx * ny);
    }
    SECTION("a far offset of the gap") {
        const Values h = problem.gap([&](double x, double y) { return (sphere(x, y / R) + 1e3) - (1e3 + 0.01); });
        CHECK(check_contact_conditions(problem, h, problem.solve(h)) > 0);
    }
}

TEST_CASE("no overlap means no contact", "[normal]") {
    const Case problem(Grid::of_elements(9, 8, 0.1, 0.1));
    const auto solution = problem.solve(Values(72, 0.1), GENERATE(Values{}, Values(72, 5.0)));
    CHECK(solution.evidence.converged);
    CHECK(largest(solution.pressure) == 0);
}

TEST_CASE("a single element in contact carries h/A", "[normal]") {
    const Case problem(Grid::of_elements(5, 5, 0.1, 0.1));
    Values h(25, 1.0);
    h[12] = -0.01;
    const auto solution = problem.solve(h);
    CHECK(solution.evidence.converged);
    CHECK_THAT(solution.pressure[12], WithinRel(0.01 / problem.table(Axis::z, Axis::z, 0, 0), 1e-12));
    CHECK(check_contact_conditions(problem, h, solution) == 1);
}

TEST_CASE("the estimate does not change the answer", "[normal]") {
    const Case problem(Grid::of_elements(18, 18, 0.13, 0.13));
    const Values h = problem.gap([](double x, double y) { return sphere(x, y) - 0.01; });
    const auto plain = problem.solve(h);
    const auto same = [&](const Values& initial) {
        const auto solution = problem.solve(h, initial);
        check_contact_conditions(problem, h, solution);
        for (std::size_t i = 0; i < h.size(); ++i)
            CHECK_THAT(solution.pressure[i], WithinAbs(plain.pressure[i], 2e-5 * largest(plain.pressure)));
        return solution.evidence.iterations;
    };
    SECTION("far too large") {
        same(Values(h.size(), 1e6));
    }
    SECTION("in the wrong place") {
        Values corner(h.size());
        corner[0] = 100;
        same(corner);
    }
    SECTION("of both signs") {
        same(random_values(h.size(), 3, -50, 50));
    }
    SECTION("exact") {
        CHECK(same(plain.pressure) == 0);
    }
}

TEST_CASE("pressures of a sphere approach Hertz", "[normal]") {
    const int n = GENERATE(60, 61);
    const Case problem(Grid::of_elements(n, n, 1.3 / n, 1.3 / n));
    const auto solution = problem.solve(problem.gap([](double x, double y) { return (x * x + y * y) / 20 - 0.025; }));
    double Fn = 0;
    for (const double p : solution.pressure) Fn += p * problem.grid.element_area();
    const double modulus = 200 / (1 - 0.42), radius = 0.5;
    CHECK_THAT(Fn, WithinRel(4.0 / 3 * modulus * radius * 0.025, 1e-3));
    CHECK_THAT(largest(solution.pressure), WithinRel(2 * modulus * 0.025 / (std::acos(-1) * radius), 3e-3));
}

TEST_CASE("a solution that missed the tolerance says so", "[normal]") {
    const Case problem(Grid::of_elements(18, 18, 0.13, 0.13));
    const Values h = problem.gap([](double x, double y) { return sphere(x, y) - 0.01; });
    const auto solution = problem.solve(h, {}, {1e-6, 2});
    CHECK_FALSE(solution.evidence.converged);
    CHECK(solution.evidence.iterations == 2);
    CHECK(solution.evidence.residual > 1e-6);
    for (const double p : solution.pressure) CHECK(p >= 0);
}

TEST_CASE("normal contact can be cancelled and reports progress", "[normal]") {
    struct : Observer {
        int reports = 0;
        mutable int questions = 0;
        int cancel_at = 1000;
        void on_progress(const Progress& progress) override {
            ++reports;
            CHECK(progress.stage == "normal");
            CHECK(progress.fraction >= 0);
            CHECK(progress.fraction <= 1);
        }
        bool cancelled() const override { return ++questions >= cancel_at; }
    } observer;
    const Case problem(Grid::of_elements(18, 18, 0.13, 0.13));
    const Values h = problem.gap([](double x, double y) { return sphere(x, y) - 0.01; });
    solve_normal(problem.influence, h, {}, {}, observer);
    CHECK(observer.reports > 0);
    observer.cancel_at = observer.questions + 3;
    CHECK_THROWS_AS(solve_normal(problem.influence, h, {}, {}, observer), Cancelled);
}

TEST_CASE("arrays of the wrong size are refused", "[normal]") {
    const Case problem(Grid::of_elements(4, 4, 1, 1));
    CHECK_THROWS_AS(problem.solve(Values(15)), InvalidArgument);
    CHECK_THROWS_AS(problem.solve(Values(16), Values(3)), InvalidArgument);
}
