// Computes the closed form on a lattice of points. Neighbouring rectangles share their corners, so the logarithms and
// angles of the antiderivatives are computed once per corner.
#include "shifted_half_space.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "gauss_rules.hpp"

namespace contactd {
namespace {

// Returns differences of a (at +) and b (at -) along one axis.
KernelIntegrals minus(const KernelIntegrals& a, const KernelIntegrals& b) {
    return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy, a.x - b.x, a.y - b.y};
}

KernelIntegrals times(double factor, const KernelIntegrals& k) {
    return {factor * k.xx, factor * k.yy, factor * k.xy, factor * k.x, factor * k.y};
}

// Computes integrals for constant loads, with lengths over sqrt(dx dy), so that the force is one.
class CornerLattice {
   public:
    CornerLattice(const Lattice& points, bool coupled) : points_(points), coupled_(coupled) {
        scale_ = std::sqrt(points.dx) * std::sqrt(points.dy);
        dx_ = points.dx / scale_;
        dy_ = points.dy / scale_;
        lower_.resize(static_cast<std::size_t>(points.last_k - points.first_k + 2));
        upper_.resize(lower_.size());
        fill(upper_, points.first_l);
    }

    // Returns integrals of the points of row l. Call it in order of increasing l, from first_l on.
    void next_row(int l, std::vector<KernelIntegrals>& row) {
        std::swap(lower_, upper_);
        fill(upper_, l + 1);
        const double y = (l + points_.shift_l) * dy_;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const double x = (points_.first_k + static_cast<int>(i) + points_.shift_k) * dx_;
            const double rho2 = x * x + y * y, size = std::max(dx_, dy_);
            // Differences lose digits as rho^2; there the kernels are smooth, see kernel_integrals.cpp.
            if (rho2 > 1e4 && rho2 > 64 * size * size)
                row[i] = rho2 > 1e4 * size * size ? gauss_mean(legendre3, legendre3, x, y, 0.5 * dx_, 0.5 * dy_)
                                                  : gauss_mean(legendre6, legendre6, x, y, 0.5 * dx_, 0.5 * dy_);
            else
                row[i] = minus(minus(upper_[i + 1], upper_[i]), minus(lower_[i + 1], lower_[i]));
            row[i] = times(scale_, row[i]);
        }
    }

   private:
    void fill(std::vector<KernelIntegrals>& corners, int l) const {
        for (std::size_t i = 0; i < corners.size(); ++i)
            corners[i] = corner_antiderivatives((points_.first_k + static_cast<int>(i) - 0.5 + points_.shift_k) * dx_,
                                                (l - 0.5 + points_.shift_l) * dy_, coupled_);
    }

    const Lattice points_;
    const bool coupled_;
    double scale_, dx_, dy_;
    std::vector<KernelIntegrals> lower_, upper_;  // corners below and above the row
};

}  // namespace

void for_lattice(const HalfSpaceModel& model, const Lattice& points, const Observer& observer,
                 const std::function<void(int k, int l, const KernelIntegrals&)>& visit) {
    std::vector<KernelIntegrals> row(static_cast<std::size_t>(points.last_k - points.first_k + 1));
    std::optional<CornerLattice> corners;
    if (model.load_shape == LoadShape::constant && !model.line_contact) corners.emplace(points, model.coupled());
    for (int l = points.first_l; l <= points.last_l; ++l) {
        observer.throw_if_cancelled();
        if (corners) corners->next_row(l, row);
        for (int k = points.first_k; k <= points.last_k; ++k) {
            KernelIntegrals& integrals = row[static_cast<std::size_t>(k - points.first_k)];
            if (!corners)
                integrals = model.integrals((k + points.shift_k) * points.dx, (l + points.shift_l) * points.dy,
                                            points.dx, points.dy);
            visit(k, l, integrals);
        }
    }
}

}  // namespace contactd
