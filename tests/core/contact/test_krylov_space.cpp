#include "contact/derivatives/krylov_space.hpp"

#include <Eigen/LU>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

using namespace contactd;

namespace {

/// A matrix without symmetry, and its diagonal as a poor preconditioner.
struct Equations {
    Eigen::MatrixXd matrix;
    Observer observer;
    KrylovSpace space;

    explicit Equations(Eigen::Index size)
        : matrix(Eigen::MatrixXd::Zero(size, size)),
          space(
              size, [this](const KrylovSpace::Vector& x, KrylovSpace::Vector& y) { y = matrix * x; },
              [this](const KrylovSpace::Vector& r, KrylovSpace::Vector& z) {
                  z = r.array() / matrix.diagonal().array();
              }) {
        for (Eigen::Index i = 0; i < size; ++i)
            for (Eigen::Index j = 0; j < size; ++j)
                matrix(i, j) = i == j ? 2.0 + static_cast<double>(i % 3)
                                      : 0.025 * std::sin(static_cast<double>(7 * i + 3 * j * j));
    }
};

}  // namespace

TEST_CASE("equations without symmetry are solved to the tolerance", "[derivatives]") {
    Equations equations(40);
    const KrylovSpace::Vector right = KrylovSpace::Vector::LinSpaced(40, -1, 2);
    const auto solution = equations.space.solve(right, right.norm(), 1e-9, equations.observer);
    CHECK(solution.relative <= 1e-9);
    CHECK((right - equations.matrix * solution.x).norm() <= 2e-9 * right.norm());
    CHECK((right - equations.matrix * solution.x - solution.residual).norm() <= 1e-12 * right.norm());
    CHECK(equations.space.steps() < 40);
}

TEST_CASE("a right-hand side that others span takes no further step", "[derivatives]") {
    Equations equations(30);
    const KrylovSpace::Vector a = KrylovSpace::Vector::LinSpaced(30, -1, 2), b = a.array().square();
    equations.space.solve(a, a.norm(), 1e-12, equations.observer);
    equations.space.solve(b, b.norm(), 1e-12, equations.observer);
    const int steps = equations.space.steps();
    const KrylovSpace::Vector both = 3 * a - 2 * b;
    const auto solution = equations.space.solve(both, both.norm(), 1e-9, equations.observer);
    CHECK(solution.relative <= 1e-9);
    CHECK(equations.space.steps() == steps);
}

TEST_CASE("a right-hand side of rounding alone needs no solution", "[derivatives]") {
    Equations equations(10);
    const KrylovSpace::Vector right = KrylovSpace::Vector::Constant(10, 1e-17);
    const auto solution = equations.space.solve(right, 1, 1e-4, equations.observer);
    CHECK(solution.relative <= 1e-4);
    CHECK(equations.space.steps() == 0);
}

TEST_CASE("equations without a solution end unsolved", "[derivatives]") {
    Equations equations(10);
    equations.matrix.row(3).setZero();
    equations.matrix(3, 3) = 1e-300;
    const KrylovSpace::Vector right = KrylovSpace::Vector::Ones(10);
    CHECK(equations.space.solve(right, right.norm(), 1e-6, equations.observer).relative > 0.1);
}
