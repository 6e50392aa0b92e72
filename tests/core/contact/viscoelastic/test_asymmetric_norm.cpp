// Tests normal contact of operators that are not symmetric, with matrices unlike those of bodies.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <numeric>

#include "contact/normal/normal.hpp"
#include "contact/random_problems.hpp"
#include "contactd/error.hpp"
#include "viscoelastic_cases.hpp"

using namespace contactd;
using namespace contactd::test;

namespace {

/// Has a positive definite symmetric part, and a skew-symmetric part.
class SkewOperator final : public InfluenceOperator {
   public:
    SkewOperator(std::size_t n, double skewness, Dice& dice) : n_(n), a_(n * n) {
        Values b(n * n);
        for (double& value : b) value = dice.uniform(-1, 1);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                for (std::size_t k = 0; k < n; ++k)
                    a_[i * n + j] += b[i * n + k] * b[j * n + k] / static_cast<double>(n);
                if (i == j) a_[i * n + j] += 0.2;
                if (i < j) {
                    const double value = skewness * dice.uniform(-1, 1);
                    a_[i * n + j] += value;
                    a_[j * n + i] -= value;
                }
            }
    }

    std::size_t size() const override { return n_; }
    void normal(std::span<const double> pz, std::span<double> uz) const override {
        for (std::size_t i = 0; i < n_; ++i)
            uz[i] = std::inner_product(pz.begin(), pz.end(), a_.begin() + static_cast<std::ptrdiff_t>(i * n_), 0.0);
    }
    void tangential(std::span<const double>, std::span<const double>, std::span<double>,
                    std::span<double>) const override {}
    bool is_symmetric() const override { return false; }
    Values diagonal(Axis) const override {
        Values values;
        for (std::size_t i = 0; i < n_; ++i) values.push_back(a_[i * n_ + i]);
        return values;
    }
    void precondition(Axis, std::span<const double> r, std::span<double> z) const override {
        for (std::size_t i = 0; i < n_; ++i) z[i] = r[i] / a_[i * n_ + i];
    }
    std::size_t bytes() const override { return a_.size() * sizeof(double); }

   private:
    std::size_t n_;
    Values a_;
};

}  // namespace

TEST_CASE("pressures are found for operators of any skew-symmetric part", "[viscoelastic]") {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        Dice dice(seed);
        const auto n = static_cast<std::size_t>(dice.integer(2, 40));
        const SkewOperator influence(n, dice.log_uniform(0.01, 10), dice);
        Values h(n), u(n);
        for (double& value : h) value = dice.uniform(-1, 1);
        Observer observer;
        const bool by_force = dice.chance(0.5);
        const SolverSettings settings{1e-9, 20000};
        const NormalSolution found = by_force ? solve_normal_force(influence, h, 0.5, settings, {}, observer)
                                              : solve_normal(influence, h, settings, {}, observer);
        REQUIRE(found.evidence.converged);
        influence.normal(found.pressure, u);
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double gap = u[i] + h[i] - found.approach;
            sum += found.pressure[i];
            CHECK(found.pressure[i] >= 0);
            CHECK((found.pressure[i] > 0 ? std::abs(gap) : -gap) < 1e-7);
        }
        if (by_force) CHECK(std::abs(sum - 0.5) < 1e-9);
    }
}

TEST_CASE("pressures of bodies that creep end when they are cancelled", "[viscoelastic]") {
    const ContactProblem problem = spheres(24, 1, 5e-3);
    const ContactInfluence influence = operators_of(problem, pair_table(problem));
    struct Cancelling final : Observer {
        bool cancelled() const override { return true; }
    } observer;
    CHECK_THROWS_AS(solve_contact(problem, influence, observer), Cancelled);
}

TEST_CASE("pressures of bodies that creep tell how far they are", "[viscoelastic]") {
    const ContactProblem problem = spheres(40, 5, 5e-3);
    const ContactInfluence influence = operators_of(problem, pair_table(problem));
    struct Listening final : Observer {
        void on_progress(const Progress& progress) override { reports += progress.stage == "normal"; }
        int reports = 0;
    } observer;
    const ContactSolution solution = solve_contact(problem, influence, observer);
    CHECK(observer.reports > 0);
    CHECK(solution.evidence.normal.iterations < 60);
}

TEST_CASE("pressures of bodies that creep go on from those of the step before", "[viscoelastic]") {
    ContactProblem problem = spheres(64, 5, 5e-3);
    const ContactInfluence influence = operators_of(problem, pair_table(problem));
    Observer observer;
    const ContactSolution first = solve_contact(problem, influence, observer);
    problem.initial = {first.pressure, first.traction_x, first.traction_y};
    problem.Fn = 1.01 * *problem.Fn;
    const ContactSolution next = solve_contact(problem, influence, observer);
    problem.initial = {};
    const ContactSolution anew = solve_contact(problem, influence, observer);
    CHECK(next.converged());
    CHECK(next.evidence.normal.iterations <= anew.evidence.normal.iterations + 5);
    CHECK(std::abs(next.pmax / anew.pmax - 1) < 1e-7);
}
