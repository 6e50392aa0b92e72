// Divides the contact area of FASTSIM into its own slices, from which its forces are computed.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "closed_forms/dual.hpp"
#include "closed_forms/quad.hpp"
#include "closed_forms/rolling_frame.hpp"
#include "fastsim.hpp"
#include "fastsim_slice.hpp"

namespace contactd {

template <class Number>
struct FastsimTotals {
    Number Fx{}, Fy{}, Mz{}, power{}, slip_area{};  // in the rolling frame; power over the rolling velocity
};

// Holds the positions of slices and the ends of steps, for an ellipse of semi-axes 1.
struct FastsimNodes {
    std::vector<double> positions;      // x over half the chord, after the leading edge
    std::vector<Quad> heights, widths;  // sizes of the slices over b; those beyond the last have no width

    explicit FastsimNodes(const FastsimSettings& settings);
};

// Slices are at y = b sin t for equally spaced t, steps at x = a(y) cos s for equally spaced s. So steps are small at
// the edges, where traction changes from adhesion to zero.
class FastsimEllipse {
   public:
    FastsimEllipse(const RollingFrame& frame, const Material& combined, double bound, const FastsimSettings& settings);

    FastsimTotals<double> totals(const FastsimCreepages<double>& creepages) const;
    FastsimTotals<Dual> totals(const FastsimCreepages<Dual>& creepages) const;

    template <class Number>
    FastsimLaw<Number> law(const FastsimCreepages<Number>& creepages) const {
        const double mean = 0.5 * (L_.L1 + L_.L2);
        return {bound_,
                1 / (axes_.a * axes_.a),
                (1 / L_.L2) * creepages.eta,
                (1 / L_.L3) * creepages.phi,
                mean / L_.L1,
                mean / L_.L2};
    }
    // Returns a slice; y is one number or four, as in `Number`.
    template <class Number, class Y>
    FastsimSlice<Number> slice(const FastsimCreepages<Number>& creepages, const Y& y) const {
        return {1 - y * y / (axes_.b * axes_.b), (1 / L_.L1) * creepages.xi - y / L_.L3 * creepages.phi};
    }
    template <class Y>
    Y half_chord(const Y& y) const {
        using std::sqrt;
        return axes_.a * sqrt(1 - y * y / (axes_.b * axes_.b));
    }
    const Flexibilities& L() const { return L_; }

   private:
    template <class Number>
    FastsimTotals<Number> totals_of_four(const FastsimCreepages<Number>& creepages) const;

    SemiAxes axes_;
    Flexibilities L_;
    double bound_;
    std::shared_ptr<const FastsimNodes> nodes_;
};

}  // namespace contactd
