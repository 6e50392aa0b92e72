#include "secant_history.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

// A step is linearly dependent if its squared relative distance from the others is below this.
constexpr double dependent = 1e-12;

// The size is rounded up to one of eight sizes for each power of two, so that a contact area that changes by a few
// elements reuses the memory of the last one.
std::size_t rounded_up(std::size_t size) {
    const std::size_t part = std::max<std::size_t>(std::bit_floor(size) / 8, 1);
    return (size + part - 1) / part * part;
}

}  // namespace

SecantHistory::SecantHistory(std::size_t m, std::size_t capacity)
    : m_(m),
      capacity_(capacity + 1),
      values_(std::make_unique_for_overwrite<double[]>(rounded_up(capacity_ * parts * 2 * m))),
      rigid_(capacity_),
      forces_(capacity_),
      products_(capacity_ * capacity_),
      factor_(capacity_ * capacity_),
      right_(capacity_),
      scale_(capacity_) {
    used_.reserve(capacity_);
}

void SecantHistory::clear() {
    size_ = permanent_;
    first_ = 0;
}

void SecantHistory::accept(const Pair& rigid) {
    rigid_[slot(size_)] = rigid;
    if (size_ + 1 < capacity_)
        ++size_;
    else
        first_ = (first_ + 1) % (capacity_ - permanent_);
}

void SecantHistory::update_products(std::size_t j) {
    for (std::size_t i = 0; i <= j; ++i) {
        const double value = dot_product(2 * m_, view(slot(i), image_part).x, view(slot(j), image_part).x) +
                             forces_[slot(i)].dot(forces_[slot(j)]);
        product(slot(i), slot(j)) = value;
        product(slot(j), slot(i)) = value;
    }
}

double SecantHistory::product_with(std::size_t slot_index, const Field& r, const Pair& forces) {
    const FieldView image = view(slot_index, image_part);
    const double of_forces = forces_[slot_index].dot(forces);
    if (knows_newest_) return dot_product(m_, image.x, r.x.data()) + dot_product(m_, image.y, r.y.data()) + of_forces;
    const std::size_t newest_slot = slot(size_ - 1);
    const FieldView newest = view(newest_slot, image_part);
    const TwoProducts x = dot_products(m_, image.x, newest.x, r.x.data()),
                      y = dot_products(m_, image.y, newest.y, r.y.data());
    const double with_newest = x.b + y.b + forces_[slot_index].dot(forces_[newest_slot]);
    product(slot_index, newest_slot) = with_newest;
    product(newest_slot, slot_index) = with_newest;
    return x.c + y.c + of_forces;
}

// Solves the normal equations by Cholesky, newest step first, so that old ones are dropped if steps are dependent. The
// next iteration corrects rounding errors.
Pair SecantHistory::minimise(Field& r, Pair& forces, Field& d) {
    std::fill(d.x.begin(), d.x.end(), 0.0);
    std::fill(d.y.begin(), d.y.end(), 0.0);
    used_.clear();
    for (std::size_t age = 0; age < size_; ++age) {
        const std::size_t j = slot(size_ - 1 - age);
        const double with_r = product_with(j, r, forces), length_squared = product(j, j);
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
        double value = with_r * scale_[row];
        for (std::size_t k = 0; k < row; ++k) value -= factors[k] * right_[k];
        right_[row] = value / factors[row];
        used_.push_back(j);
    }
    for (std::size_t row = used_.size(); row-- > 0;) {
        for (std::size_t below = row + 1; below < used_.size(); ++below)
            right_[row] -= factor_[below * capacity_ + row] * right_[below];
        right_[row] /= factor_[row * capacity_ + row];
    }
    knows_newest_ = true;
    Pair rigid = Pair::Zero();
    for (std::size_t row = 0; row < used_.size(); ++row) {
        right_[row] *= scale_[row];
        forces -= right_[row] * forces_[used_[row]];
        rigid += right_[row] * rigid_[used_[row]];
    }
    add(image_part, -1, r);
    add(step_part, 1, d);
    return rigid;
}

// Computes to += sign sum right_j part_j, four at a time, so that the sum is read and written less often.
void SecantHistory::add(Part part, double sign, Field& to) const {
    for (std::size_t first = 0; first < used_.size(); first += 4) {
        FourArrays x{}, y{};
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t row = std::min(first + k, used_.size() - 1);
            const FieldView values = view(used_[row], part);
            x.factors[k] = first + k < used_.size() ? sign * right_[row] : 0;
            y.factors[k] = x.factors[k];
            x.values[k] = values.x;
            y.values[k] = values.y;
        }
        add_four(m_, x, to.x.data());
        add_four(m_, y, to.y.data());
    }
}

}  // namespace contactd
