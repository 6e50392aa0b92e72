#include "secant_history.hpp"

#include <cmath>

namespace contactd {
namespace {

constexpr double dependent = 1e-12;  // squared distance from the others, relative, at which a step adds nothing

void add(double factor, const FieldView& a, Field& to) {
    for (std::size_t e = 0; e < to.x.size(); ++e) to.x[e] += factor * a.x[e];
    for (std::size_t e = 0; e < to.y.size(); ++e) to.y[e] += factor * a.y[e];
}

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
        const double value = dot(flat(slot(i), image_part), flat(slot(j), image_part));
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
        double value = (dot({image.x, m_}, r.x) + dot({image.y, m_}, r.y)) * scale_[row];
        for (std::size_t k = 0; k < row; ++k) value -= factors[k] * right_[k];
        right_[row] = value / factors[row];
        used_.push_back(j);
    }
    for (std::size_t row = used_.size(); row-- > 0;) {
        for (std::size_t below = row + 1; below < used_.size(); ++below)
            right_[row] -= factor_[below * capacity_ + row] * right_[below];
        right_[row] /= factor_[row * capacity_ + row];
    }
    for (std::size_t row = 0; row < used_.size(); ++row) {
        const double coefficient = right_[row] * scale_[row];
        add(-coefficient, view(used_[row], image_part), r);
        add(coefficient, view(used_[row], step_part), d);
    }
}

}  // namespace contactd
