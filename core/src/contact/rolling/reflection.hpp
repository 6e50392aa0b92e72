// Reflects arrays over a grid, which transposes operators.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "contactd/grid.hpp"

namespace contactd {

// An operator K with coefficients k_ab(r) of the offset r has the transpose k_ba(-r). By reciprocity k_ab(r) = k_ba(-r)
// without a step, the transpose of a step of rolling is the step backwards. Seen by somebody who turns by half a turn
// about z, it is the same step forwards: the transpose is R K R, with R the reflection at the centre of the grid, which
// reverses x, y and the components along them. Bodies that are only uniform along x use the reflection along x.
class Reflection {
   public:
    enum class Axes { both, along_x };

    Reflection(const Grid& grid, Axes axes)
        : nx_(static_cast<std::size_t>(grid.nx)), ny_(static_cast<std::size_t>(grid.ny)), axes_(axes) {}

    std::size_t image(std::size_t i) const {
        const std::size_t ix = i % nx_, iy = i / nx_;
        return (axes_ == Axes::both ? ny_ - 1 - iy : iy) * nx_ + nx_ - 1 - ix;
    }
    static constexpr double sign_x = -1;
    double sign_y() const { return axes_ == Axes::both ? -1 : 1; }
    bool at_centre() const { return axes_ == Axes::both; }

    void take(std::span<const double> from, double sign, std::span<double> to) const {
        for (std::size_t i = 0; i < from.size(); ++i) to[image(i)] = sign * from[i];
    }

   private:
    std::size_t nx_, ny_;
    Axes axes_;
};

}  // namespace contactd
