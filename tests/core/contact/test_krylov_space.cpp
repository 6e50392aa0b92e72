#include "contact/derivatives/krylov_space.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>

using namespace contactd;

namespace {

using Vector = KrylovSpace::Vector;
using Matrix = KrylovSpace::Matrix;

/// Provides a matrix, symmetric or not, with its diagonal as a poor preconditioner, and all unknowns as outputs.
struct Example {
    Matrix matrix;
    bool symmetric;
    Observer observer;

    explicit Example(Eigen::Index size, bool symmetric_ = false)
        : matrix(Matrix::Zero(size, size)), symmetric(symmetric_) {
        for (Eigen::Index i = 0; i < size; ++i)
            for (Eigen::Index j = 0; j < size; ++j)
                matrix(i, j) = i == j ? 2.0 + static_cast<double>(i % 3)
                                      : 0.025 * std::sin(static_cast<double>(7 * i + 3 * j * j));
        if (symmetric) matrix = 0.5 * Matrix(matrix + matrix.transpose());
    }

    KrylovSpace solved(const std::vector<Vector>& rights, const KrylovSpace::Tolerance& tolerance,
                       double size = 0) const {
        std::vector<KrylovSpace::Right> all;
        for (const Vector& right : rights)
            all.push_back({right, size > 0 ? size : right.norm(), Vector::Zero(right.size())});
        const auto n = matrix.rows();
        KrylovSpace space({[this](const Vector& x, Vector& y) { y = matrix * x; },
                           [this](const Vector& r, Vector& z, int) { z = r.array() / matrix.diagonal().array(); },
                           symmetric, Vector::LinSpaced(n, 1, 2), Matrix::Identity(n, n), n});
        space.solve(all, tolerance, observer);
        return space;
    }
    double left(const Vector& right, const Vector& x) const { return (right - matrix * x).norm() / right.norm(); }
};

const Vector linear = Vector::LinSpaced(40, -1, 2), square = linear.array().square();

}  // namespace

TEST_CASE("equations are solved to the tolerance", "[derivatives]") {
    const Example equations(40, GENERATE(false, true));
    const KrylovSpace space = equations.solved({linear, square}, {1e-9});
    CHECK(space.converged());
    CHECK(space.residual() <= 1e-9);
    CHECK(equations.left(linear, space.sums(0)) <= 4e-9);
    CHECK(equations.left(square, space.sums(1)) <= 4e-9);
    CHECK(space.steps() < 40);
    CHECK((space.solution(1) - space.sums(1)).norm() <= 1e-12 * space.sums(1).norm());
}

TEST_CASE("leading components of solutions are kept", "[derivatives]") {
    const Example equations(40);
    KrylovSpace space({[&](const Vector& x, Vector& y) { y = equations.matrix * x; },
                       [](const Vector& r, Vector& z, int) { z = r; }, false, Vector::LinSpaced(40, 1, 2),
                       Matrix::Identity(40, 40), 15});
    space.solve({{linear, linear.norm(), Vector::Zero(40)}, {square, square.norm(), Vector::Zero(40)}}, {1e-9},
                equations.observer);
    CHECK((space.solution(0) - space.sums(0).head(15)).norm() <= 1e-12 * space.sums(0).norm());
    CHECK((space.solution(1) - space.sums(1).head(15)).norm() <= 1e-12 * space.sums(1).norm());
}

TEST_CASE("a right-hand side that others span takes no further step", "[derivatives]") {
    const Example equations(40, GENERATE(false, true));
    const KrylovSpace two = equations.solved({linear, square}, {1e-9});
    const KrylovSpace three = equations.solved({linear, square, 3 * linear - 2 * square}, {1e-9});
    CHECK(equations.left(3 * linear - 2 * square, three.sums(2)) <= 4e-9);
    CHECK(three.steps() <= two.steps() + 1);
}

TEST_CASE("what is known of sums is added to them", "[derivatives]") {
    const Example equations(40);
    const KrylovSpace without = equations.solved({linear}, {1e-9});
    KrylovSpace with({[&](const Vector& x, Vector& y) { y = equations.matrix * x; },
                      [](const Vector& r, Vector& z, int) { z = r; }, false, Vector::Ones(40),
                      Matrix::Identity(40, 40)});
    with.solve({{linear, linear.norm(), square}}, {1e-9}, equations.observer);
    CHECK((with.sums(0) - square - without.sums(0)).norm() <= 1e-8);
}

TEST_CASE("sums of symmetric equations err by the square of the residual", "[derivatives]") {
    const Example equations(40, true);
    const KrylovSpace rough = equations.solved({linear}, {1e-3}), exact = equations.solved({linear}, {1e-12});
    const double missing = linear.dot(exact.sums(0) - rough.sums(0)) / linear.dot(exact.sums(0));
    CHECK(std::abs(missing) <= 1e-6);
    CHECK((exact.sums(0) - rough.sums(0)).norm() >= 1e-5 * exact.sums(0).norm());
}

TEST_CASE("steps end where they hardly change the sums", "[derivatives]") {
    const Example equations(40);
    const auto change = [](const Vector& now, const Vector& before) { return (now - before).norm() / now.norm(); };
    const KrylovSpace exact = equations.solved({linear}, {1e-12});
    const KrylovSpace rough = equations.solved({linear}, {1e-12, 1e-4, change});
    CHECK(rough.converged());
    CHECK(rough.steps() < exact.steps());
    CHECK((rough.sums(0) - exact.sums(0)).norm() <= 1e-4 * exact.sums(0).norm());
}

TEST_CASE("a right-hand side of rounding alone needs no solution", "[derivatives]") {
    const KrylovSpace space = Example(10).solved({Vector::Constant(10, 1e-17)}, {1e-4}, 1);
    CHECK(space.converged());
    CHECK(space.residual() <= 1e-4);
    CHECK(space.steps() == 0);
}

TEST_CASE("equations without a solution end unsolved", "[derivatives]") {
    Example equations(10);
    equations.matrix.row(3).setZero();
    equations.matrix(3, 3) = 1e-300;
    const KrylovSpace space = equations.solved({Vector::Ones(10)}, {1e-6});
    CHECK(!space.converged());
    CHECK(space.residual() > 0.1);
}
