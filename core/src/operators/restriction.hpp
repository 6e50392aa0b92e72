// Restricts an influence operator to a box of elements around a contact. If the box is much smaller than the potential
// contact area, products cost correspondingly less.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "contactd/grid.hpp"
#include "contactd/influence_operator.hpp"

namespace contactd {

/// Returns the smallest box with all elements that satisfy the predicate, which takes an element's index; nx = ny = 0
/// if there are none.
template <class Predicate>
ElementBox bounding_box(const ElementBox& extent, const Predicate& belongs) {
    int left = extent.nx, right = -1, bottom = extent.ny, top = -1;
    for (int iy = 0; iy < extent.ny; ++iy)
        for (int ix = 0; ix < extent.nx; ++ix) {
            if (!belongs(static_cast<std::size_t>(iy) * static_cast<std::size_t>(extent.nx) +
                         static_cast<std::size_t>(ix)))
                continue;
            left = std::min(left, ix);
            right = std::max(right, ix);
            bottom = std::min(bottom, iy);
            top = iy;
        }
    if (right < 0) return {};
    return {left, bottom, right - left + 1, top - bottom + 1};
}

inline ElementBox united(const ElementBox& a, const ElementBox& b) {
    const int left = std::min(a.first_x, b.first_x), bottom = std::min(a.first_y, b.first_y);
    return {left, bottom, std::max(a.first_x + a.nx, b.first_x + b.nx) - left,
            std::max(a.first_y + a.ny, b.first_y + b.ny) - bottom};
}

/// Uses the whole extent or a box around the needed elements, whichever is cheaper. `influence` must outlive this
/// object.
class Restriction {
   public:
    Restriction(const InfluenceOperator& influence, const ElementBox& needed, bool may_grow)
        : whole_(influence), extent_(extent_of(influence)), box_(extent_) {
        const ElementBoxes* boxes = influence.boxes();
        if (boxes == nullptr) return;
        box_ = boxes->convenient(needed, may_grow);
        if (!(box_ == extent_)) part_ = boxes->influence(box_);
    }

    const InfluenceOperator& influence() const { return part_ ? *part_ : whole_; }
    const ElementBox& box() const { return box_; }
    bool is_whole() const { return !part_; }
    bool contains(std::size_t element) const {
        const int ix = static_cast<int>(element % static_cast<std::size_t>(extent_.nx)) - box_.first_x;
        const int iy = static_cast<int>(element / static_cast<std::size_t>(extent_.nx)) - box_.first_y;
        return ix >= 0 && ix < box_.nx && iy >= 0 && iy < box_.ny;
    }

    std::vector<double> crop(std::span<const double> whole) const {
        std::vector<double> part(box_.size());
        for (int iy = 0; iy < box_.ny; ++iy) std::copy_n(whole.begin() + row(iy), box_.nx, part.begin() + iy * box_.nx);
        return part;
    }
    Grid crop(Grid grid) const {
        grid.x0 += box_.first_x * grid.dx;
        grid.y0 += box_.first_y * grid.dy;
        grid.nx = box_.nx;
        grid.ny = box_.ny;
        return grid;
    }
    /// Copies a part into the whole array; values outside the box do not change.
    template <class Value>
    void paste(const std::vector<Value>& part, std::vector<Value>& whole) const {
        for (int iy = 0; iy < box_.ny; ++iy) std::copy_n(part.begin() + iy * box_.nx, box_.nx, whole.begin() + row(iy));
    }

   private:
    std::ptrdiff_t row(int iy) const {
        return static_cast<std::ptrdiff_t>(box_.first_y + iy) * extent_.nx + box_.first_x;
    }

    const InfluenceOperator& whole_;
    const ElementBox extent_;
    ElementBox box_;
    std::shared_ptr<const InfluenceOperator> part_;
};

}  // namespace contactd
