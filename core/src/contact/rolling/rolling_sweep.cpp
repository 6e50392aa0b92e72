#include "rolling_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/support/traction_loops.hpp"

namespace contactd {
namespace {

constexpr double negligible = 1e-9;  // weight of a neighbour

// A distance in elements, split for interpolation between the two that it falls between.
struct Between {
    int first;      // nearer one, towards the leading edge
    int direction;  // of the particle's origin
    std::array<double, 2> weights;

    Between(double distance) {
        const double length = std::abs(distance);
        direction = distance < 0 ? -1 : 1;
        // More than this many elements away nothing is inside contact; the bound keeps the cast defined.
        first = static_cast<int>(std::min(std::floor(length + negligible), 1e8));
        const double fraction = std::clamp(length - first, 0.0, 1.0);
        weights = {1 - fraction, fraction};
    }
};

}  // namespace

RollingSweep::RollingSweep(const Grid& grid, double step_x, double step_y, const Contact& contact,
                           std::vector<double> stiffness)
    : m_(contact.size()), stiffness_(std::move(stiffness)), inverse_diagonal_(m_), z_(m_ + 1) {
    const Between along_x(step_x / grid.dx), along_y(step_y / grid.dy);
    struct Offset {
        int x, y;
        double weight;
    };
    std::vector<Offset> offsets;
    for (int b = 0; b < 2; ++b)
        for (int a = 0; a < 2; ++a) {
            const Offset offset{
                along_x.direction * (along_x.first + a), along_y.direction * (along_y.first + b),
                along_x.weights[static_cast<std::size_t>(a)] * along_y.weights[static_cast<std::size_t>(b)]};
            if (offset.weight < negligible) continue;
            if (offset.x == 0 && offset.y == 0)
                diagonal_ -= offset.weight;
            else
                offsets.push_back(offset);
        }
    for (const double value : stiffness_) diagonal_stiffness_.push_back(diagonal_ * value);
    links_ = offsets.size();
    order_.reserve(m_);
    ahead_.reserve(m_ * links_);
    std::vector<std::size_t> element_at(grid.size(), m_);
    for (std::size_t e = 0; e < m_; ++e) element_at[contact.elements[e]] = e;
    // Elements next to each other in the order do not wait for each other where particles go along an axis.
    const bool by_columns = std::abs(step_x / grid.dx) >= std::abs(step_y / grid.dy);
    const int outer_size = by_columns ? grid.nx : grid.ny, inner_size = by_columns ? grid.ny : grid.nx;
    for (int outer = 0; outer < outer_size; ++outer)
        for (int inner = 0; inner < inner_size; ++inner) {
            const int column = by_columns ? outer : inner, row = by_columns ? inner : outer;
            const int ix = along_x.direction > 0 ? grid.nx - 1 - column : column;
            const int iy = along_y.direction > 0 ? grid.ny - 1 - row : row;
            const auto at = [&](int x, int y) {
                const bool inside = x >= 0 && x < grid.nx && y >= 0 && y < grid.ny;
                return inside ? element_at[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) +
                                           static_cast<std::size_t>(x)]
                              : m_;
            };
            const std::size_t e = at(ix, iy);
            if (e == m_) continue;
            order_.push_back(e);
            for (const Offset& offset : offsets) ahead_.push_back({at(ix + offset.x, iy + offset.y), offset.weight});
        }
}

void RollingSweep::linearise(const Linearisation& linearisation) {
    linearisation_ = &linearisation;
    shifted_reciprocal(m_, linearisation.tangent_stiffness.data(), diagonal_stiffness_.data(), stiffness_.data(),
                       inverse_diagonal_.data());
    to_adhesion_ = up_to_last([&](std::size_t e) { return !linearisation.slips[e]; });
}

void RollingSweep::solve(const Field& r, Field& z, std::size_t count) const {
    const Linearisation& l = *linearisation_;
    const Link* link = ahead_.data();
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t e = order_[k];
        double x = r.x[e], y = r.y[e];
        for (std::size_t j = 0; j < links_; ++j, ++link) {
            x += link->weight * z_.x[link->element];
            y += link->weight * z_.y[link->element];
        }
        const double nx = l.normal.x[e], ny = l.normal.y[e], along = x * nx + y * ny;
        x -= along * nx;
        y -= along * ny;
        z_.x[e] = x * inverse_diagonal_[e];
        z_.y[e] = y * inverse_diagonal_[e];
    }
    std::copy(z_.x.begin(), z_.x.end() - 1, z.x.begin());
    std::copy(z_.y.begin(), z_.y.end() - 1, z.y.begin());
}

}  // namespace contactd
