// Computes stresses at a depth of a layered body under unit tractions on one element, at offsets from it.
#pragma once

#include <array>
#include <vector>

#include "contactd/observer.hpp"
#include "influence/layered/edge_rule.hpp"
#include "influence/layered/offset_lattice.hpp"
#include "layered_radials.hpp"
#include "patch_stress.hpp"

namespace contactd {

/// Holds the stresses under a traction along x, y and z.
using ElementStresses = std::array<StressComponents, 3>;

/// All kernels are divergences or gradients of fields made of StressRadials. Therefore, only integrals along the four
/// edges of the element are needed.
class LayeredElement {
   public:
    LayeredElement(const StressWaves& waves, double largest);

    /// Returns stresses in the order [l][k], without the part that the half-space adds in the first layer. Throws
    /// Cancelled if the observer, which is called for each row, cancels.
    std::vector<ElementStresses> at(const OffsetLattice& offsets, const Observer& observer) const;

   private:
    /// Holds sums of fields along an edge: those along e_rho with the direction cosine along x and along y, the scalar
    /// ones, and the last one with cos 2 theta.
    struct EdgeSums {
        std::array<double, StressRadial::normal_xz> x{}, y{};
        std::array<double, StressRadial::count> scalar{};
    };
    EdgeSums across_x(double x, double from, double to) const;  // along an edge at x
    EdgeSums across_y(double y, double from, double to) const;
    void add(const StressRadial::Values& values, double cos, double sin, double weight, EdgeSums& sums) const;
    static ElementStresses stresses(const EdgeSums& left, const EdgeSums& right, const EdgeSums& bottom,
                                    const EdgeSums& top);

    StressRadials radials_;
    EdgeRule rule_;
};

}  // namespace contactd
