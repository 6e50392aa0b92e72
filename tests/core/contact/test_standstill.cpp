// Tests cases in which Newton's method on the friction law makes no further progress.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <memory>
#include <utility>

#include "contact_cases.hpp"
#include "contactd/contact_influence.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::WithinAbs;

namespace {

/// Represents an operator whose preconditioner of tractions returns nothing at first, and whose elements seem stiff, so
/// that no step makes progress.
class StuckOperator final : public InfluenceOperator {
   public:
    StuckOperator(std::shared_ptr<const InfluenceOperator> inner, int calls) : inner_(std::move(inner)), left_(calls) {}

    bool is_stuck() const { return left_ > 0; }

    std::size_t size() const override { return inner_->size(); }
    void normal(std::span<const double> pz, std::span<double> uz) const override { inner_->normal(pz, uz); }
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override {
        inner_->tangential(px, py, ux, uy);
    }
    std::vector<double> diagonal(Axis i) const override {
        Values stiff = inner_->diagonal(i);
        if (i != Axis::z && is_stuck())
            for (double& value : stiff) value *= 1e9;
        return stiff;
    }
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override {
        inner_->precondition(i, r, z);
    }
    void precondition_tangential(std::span<const double> rx, std::span<const double> ry, std::span<double> zx,
                                 std::span<double> zy) const override {
        inner_->precondition_tangential(rx, ry, zx, zy);
        if (!is_stuck()) return;
        --left_;
        for (const auto& z : {zx, zy}) std::fill(z.begin(), z.end(), 0.0);
    }
    std::size_t bytes() const override { return inner_->bytes(); }

   private:
    const std::shared_ptr<const InfluenceOperator> inner_;
    mutable int left_;
};

}  // namespace

TEST_CASE("conjugate gradients or a march go on where Newton's method stands still", "[contact]") {
    ContactProblem problem = cattaneo_problem(16);
    const bool rolls = GENERATE(false, true);
    if (rolls) problem.motion = Rolling{.xi = 4e-3};
    const ContactInfluence influence = operators_of(problem, pair_table(problem));
    Observer observer;
    const ContactSolution expected = solve_contact(problem, influence, observer);
    // Newton's method makes this number of calls before it gives up, for both halves of the preconditioner of rolling.
    const auto stuck = std::make_shared<StuckOperator>(influence.current, rolls ? 64 : 31);
    const ContactSolution solution = solve_contact(problem, {stuck, influence.increment}, observer);

    CHECK_FALSE(stuck->is_stuck());
    REQUIRE(solution.converged());
    INFO(solution.evidence.tangential->iterations);
    CHECK(solution.evidence.tangential->iterations > 30 + (rolls ? 0 : expected.evidence.tangential->iterations));
    CHECK_THAT(solution.forces.Fx, WithinAbs(expected.forces.Fx, 1e-5 * 0.4 * expected.forces.Fn));
    CHECK(solution.element_division == expected.element_division);
}
