#include "secant_history.hpp"

#include <cmath>

#include "traction_loops.hpp"

namespace contactd {
namespace {

constexpr double dependent = 1e-12;  // squared distance from the others, relative, at which a step adds nothing

}  // namespace

SecantHistory::SecantHistory(std::size_t m, std::size_t capacity)
    : m_(m),
      capacity_(capacity + 1),
      values_(std::make_unique_for_overwrite<double[]>(capacity_ * parts * 2 * m)),
      products_(capacity_ * capacity_),
      factor_(capacity_ * capacity_),
      right_(capacity_),
      scale_(capacity_) {
    used_.reserve(capacity_);
}

void SecantHistory::accept() {
    if (size_ + 1 < capacity_)
        ++size_;
    else
        first_ = (first_ + 1) % capacity_;
}

void SecantHistory::update_products(std::size_t j) {
    for (std::size_t i = 0; i <= j; ++i) {
        const double value = dot_product(2 * m_, view(slot(i), image_part).x, view(slot(j), image_part).x);
        product(slot(i), slot(j)) = value;
        product(slot(j), slot(i)) = value;
    }
}

// Normal equations by Cholesky, newest step first so that old ones are dropped where steps depend on each other. What
// rounding costs in them the next iteration repairs.
void SecantHistory::minimise(Field& r, Field& d) {
    std::fill(d.x.begin(), d.x.end(), 0.0);
    std::fill(d.y.begin(), d.y.end(), 0.0);
    used_.clear();
    for (std::size_t age = 0; age < size_; ++age) {
        const std::size_t j = slot(size_ - 1 - age);
        const double length_squared = product(j, j);
        if (!(length_squared > 0)) continue;
        const std::size_t row = used_.size();
        double* factors = &factor_[row * capacity_];
        scale_[row] = 1 / std::sqrt(length_squared);
        double pivot = 1;
        for (std::size_t i = 0; i < row; ++i) {
            double value = product(j, used_[i]) * scale_[row] * scale_[i];
            for (std::size_t k = 0; k < i; ++k) value -= factors[k] * factor_[i * capacity_ + k];
            factors[i] = value / factor_[i * capacity_ + i];
            pivot -= factors[i] * factors[i];
        }
        if (pivot < dependent) continue;
        factors[row] = std::sqrt(pivot);
        const FieldView image = view(j, image_part);
        double value = (dot_product(m_, image.x, r.x.data()) + dot_product(m_, image.y, r.y.data())) * scale_[row];
        for (std::size_t k = 0; k < row; ++k) value -= factors[k] * right_[k];
        right_[row] = value / factors[row];
        used_.push_back(j);
    }
    for (std::size_t row = used_.size(); row-- > 0;) {
        for (std::size_t below = row + 1; below < used_.size(); ++below)
            right_[row] -= factor_[below * capacity_ + row] * right_[below];
        right_[row] /= factor_[row * capacity_ + row];
    }
    for (std::size_t row = 0; row < used_.size(); row += 2) {
        const bool is_last = row + 1 == used_.size();
        const std::size_t j = used_[row], k = is_last ? j : used_[row + 1];
        const double of_j = right_[row] * scale_[row], of_k = is_last ? 0 : right_[row + 1] * scale_[row + 1];
        const auto add = [&](double sign, Part part, Field& to) {
            const FieldView a = view(j, part), b = view(k, part);
            add_two(m_, sign * of_j, a.x, sign * of_k, b.x, to.x.data());
            add_two(m_, sign * of_j, a.y, sign * of_k, b.y, to.y.data());
        };
        add(-1, image_part, r);
        add(1, step_part, d);
    }
}

}  // namespace contactd
