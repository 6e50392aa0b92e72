#include "krylov_space.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace contactd {
namespace {

constexpr Eigen::Index most_steps = 500, fewest_steps = 50, kept_values = 32 << 20;
constexpr double cancelled_digits = 0.01;  // fraction of an image below which it is made orthogonal again
constexpr double least_fall = 0.2;         // least decrease of the change of sums from step to step
constexpr double dependent = 1e-12;        // fraction at which a step is linearly dependent

// A right-hand side that is shorter than this fraction of its size counts as that long, because it may consist of
// rounding errors.
constexpr double rounding = 1e-7;

}  // namespace

KrylovSpace::KrylovSpace(LinearEquations equations)
    : equations_(std::move(equations)),
      size_(equations_.weights.size()),
      kept_(equations_.symmetric ? size_ : equations_.kept),
      most_(std::clamp(kept_values / std::max<Eigen::Index>(size_ + equations_.kept, 1), fewest_steps, most_steps)),
      images_(size_, 0),
      directions_(kept_, 0),
      direction_sums_(equations_.outputs.cols(), 0),
      step_(size_),
      image_(size_) {}

void KrylovSpace::begin(const std::vector<Right>& rights) {
    const auto count = static_cast<Eigen::Index>(rights.size());
    residuals_.resize(size_, count);
    sums_.resize(equations_.outputs.cols(), count);
    shares_.resize(0, count);
    states_.resize(rights.size());
    for (Eigen::Index i = 0; i < count; ++i) {
        const Right& right = rights[static_cast<std::size_t>(i)];
        const Vector weighted = right.values.cwiseProduct(equations_.weights);
        residuals_.col(i) = equations_.symmetric ? right.values : weighted;
        sums_.col(i) = right.known;
        states_[static_cast<std::size_t>(i)].length =
            (right.measure > 0 ? right.measure : 1) * std::max(weighted.norm(), rounding * right.size);
    }
}

double KrylovSpace::relative(Eigen::Index right) const {
    const double length = states_[static_cast<std::size_t>(right)].length;
    if (!(length > 0)) return 0;
    const auto residual = residuals_.col(right);
    return (equations_.symmetric ? residual.cwiseProduct(equations_.weights).norm() : residual.norm()) / length;
}

void KrylovSpace::solve(const std::vector<Right>& rights, const Tolerance& tolerance, const Observer& observer) {
    begin(rights);
    converged_ = true;
    for (bool goes_on = true; goes_on;) {
        goes_on = false;
        for (Eigen::Index i = 0; i < residuals_.cols(); ++i) {
            State& state = states_[static_cast<std::size_t>(i)];
            state.ended = state.ended || relative(i) <= tolerance.residual;
            if (state.ended) continue;
            observer.throw_if_cancelled();
            const Vector before = sums_.col(i);
            if (!add_step(i)) {
                converged_ = false;
                state.ended = true;
                continue;
            }
            goes_on = true;
            if (tolerance.change == 0) continue;
            // Future steps change sums by less and less. A small change in one step may be chance.
            const double change = std::max(tolerance.change_of(sums_.col(i), before), least_fall * state.change);
            state.ended = change * std::min(change / state.change, 1.0) <= tolerance.change;
            state.change = change;
        }
    }
    for (Eigen::Index i = 0; i < residuals_.cols(); ++i) largest_ = std::max(largest_, relative(i));
}

void KrylovSpace::make_room() {
    if (count_ < images_.cols()) return;
    const Eigen::Index columns = std::min(std::max<Eigen::Index>(16, 2 * count_), most_);
    images_.conservativeResize(size_, columns);
    directions_.conservativeResize(kept_, columns);
    direction_sums_.conservativeResize(direction_sums_.rows(), columns);
    shares_.conservativeResize(columns, shares_.cols());
}

bool KrylovSpace::add_step(Eigen::Index right) {
    if (count_ == most_) return false;
    make_room();
    residual_ = residuals_.col(right);
    if (!equations_.symmetric) residual_.array() /= equations_.weights.array();
    equations_.precondition(residual_, step_, states_[static_cast<std::size_t>(right)].steps++);
    equations_.matrix(step_, image_);
    step_sums_.noalias() = equations_.outputs.transpose() * step_;
    if (!equations_.symmetric) image_.array() *= equations_.weights.array();
    const double length = image_.norm();
    make_orthogonal(length);
    const double left = equations_.symmetric ? std::sqrt(std::max(step_.dot(image_), 0.0)) : image_.norm();
    if (!(image_.norm() > dependent * length && left > 0)) return false;
    images_.col(count_) = image_ / left;
    directions_.col(count_) = step_.head(kept_) / left;
    direction_sums_.col(count_) = step_sums_ / left;
    use_newest();
    ++count_;
    return true;
}

void KrylovSpace::make_orthogonal(double length) {
    const auto images = images_.leftCols(count_), directions = directions_.leftCols(count_);
    for (int pass = 0; pass < 2; ++pass) {
        const Vector shares = (equations_.symmetric ? directions : images).transpose() * image_;
        image_.noalias() -= images * shares;
        step_.head(kept_).noalias() -= directions * shares;
        step_sums_.noalias() -= direction_sums_.leftCols(count_) * shares;
        if (image_.norm() > cancelled_digits * length) return;
    }
}

void KrylovSpace::use_newest() {
    const auto image = images_.col(count_);
    if (equations_.symmetric)
        shares_.row(count_).noalias() = directions_.col(count_).transpose() * residuals_;
    else
        shares_.row(count_).noalias() = image.transpose() * residuals_;
    residuals_.noalias() -= image * shares_.row(count_);
    sums_.noalias() += direction_sums_.col(count_) * shares_.row(count_);
}

KrylovSpace::Vector KrylovSpace::solution(std::size_t right) const {
    return directions_.leftCols(count_) * shares_.col(static_cast<Eigen::Index>(right)).head(count_);
}

}  // namespace contactd
