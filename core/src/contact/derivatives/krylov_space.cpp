#include "krylov_space.hpp"

#include <algorithm>
#include <utility>

namespace contactd {
namespace {

constexpr Eigen::Index most_steps = 500, fewest_steps = 50, kept_values = 32 << 20;
constexpr double cancelled_digits = 0.1;  // what may be left of an image before it is made orthogonal once more
constexpr double dependent = 1e-12;       // the same, at which a step adds nothing

// Of its size, a right-hand side that is shorter is taken to be that long: what is left of it may be rounding.
constexpr double rounding = 1e-7;

}  // namespace

KrylovSpace::KrylovSpace(Eigen::Index size, Map matrix, Map precondition)
    : matrix_(std::move(matrix)),
      precondition_(std::move(precondition)),
      most_(std::clamp(kept_values / std::max<Eigen::Index>(size, 1), fewest_steps, most_steps)),
      steps_(size, 0),
      images_(size, 0),
      step_(size),
      image_(size) {}

void KrylovSpace::make_room() {
    if (count_ < steps_.cols()) return;
    const Eigen::Index columns = std::min(std::max<Eigen::Index>(16, 2 * count_), most_);
    steps_.conservativeResize(step_.size(), columns);
    images_.conservativeResize(step_.size(), columns);
    triangle_.conservativeResize(columns, columns);
}

bool KrylovSpace::add_step(const Vector& residual) {
    if (count_ == most_) return false;
    make_room();
    precondition_(residual, step_);
    matrix_(step_, image_);
    auto column = triangle_.col(count_);
    column.setZero();
    const auto before = images_.leftCols(count_);
    const double length = image_.norm();
    double left = length;
    for (int pass = 0; pass < 2; ++pass) {
        const Vector shares = before.transpose() * image_;
        image_.noalias() -= before * shares;
        column.head(count_) += shares;
        const double last = std::exchange(left, image_.norm());
        if (left > cancelled_digits * last) break;
    }
    if (!(left > dependent * length)) return false;
    column[count_] = left;
    steps_.col(count_) = step_;
    images_.col(count_) = image_ / left;
    ++count_;
    return true;
}

KrylovSpace::Solution KrylovSpace::solve(const Vector& right, double size, double tolerance, const Observer& observer) {
    Solution solution{Vector::Zero(right.size()), right, 0};
    const double length = std::max(right.norm(), rounding * size);
    if (!(length > 0)) return solution;
    Vector shares = images_.leftCols(count_).transpose() * right;
    solution.residual.noalias() -= images_.leftCols(count_) * shares;
    while (!(solution.residual.norm() <= tolerance * length)) {
        observer.throw_if_cancelled();
        if (!add_step(solution.residual)) break;
        const auto newest = images_.col(count_ - 1);
        const double share = newest.dot(solution.residual);
        solution.residual -= share * newest;
        shares.conservativeResize(count_);
        shares[count_ - 1] = share;
    }
    solution.relative = solution.residual.norm() / length;
    triangle_.topLeftCorner(count_, count_).triangularView<Eigen::Upper>().solveInPlace(shares);
    solution.x.noalias() = steps_.leftCols(count_) * shares;
    return solution;
}

}  // namespace contactd
