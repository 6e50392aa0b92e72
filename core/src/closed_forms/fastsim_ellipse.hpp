// The contact area of FASTSIM by its own slices, from which its forces come.
#pragma once

#include <memory>
#include <vector>

#include "dual.hpp"
#include "fastsim.hpp"
#include "fastsim_slice.hpp"
#include "rolling_frame.hpp"

namespace contactd {

template <class Number>
struct FastsimTotals {
    Number Fx = 0, Fy = 0, Mz = 0, power = 0, slip_area = 0;  // in the rolling frame; power over the rolling velocity
};

// Where slices lie and where steps end, for an ellipse of semi-axes 1.
struct FastsimNodes {
    std::vector<double> positions;        // of x over half the chord, after the leading edge
    std::vector<double> heights, widths;  // of the slices over b

    explicit FastsimNodes(const FastsimSettings& settings);
};

// y = b sin t at equally spaced t, x = a(y) cos s at equally spaced s, so that steps are small at the edges, where
// traction changes from adhesion to zero.
class FastsimEllipse {
   public:
    FastsimEllipse(const RollingFrame& frame, const Material& combined, double bound, const FastsimSettings& settings);

    FastsimTotals<double> totals(const FastsimCreepages<double>& creepages) const;
    FastsimTotals<Dual> totals(const FastsimCreepages<Dual>& creepages) const;

    template <class Number>
    FastsimLaw<Number> law(const FastsimCreepages<Number>& creepages) const {
        const double mean = 0.5 * (L_.L1 + L_.L2);
        return {bound_,      1 / (axes_.a * axes_.a), creepages.eta / L_.L2, creepages.phi / L_.L3, mean / L_.L1,
                mean / L_.L2};
    }
    template <class Number>
    FastsimSlice<Number> slice(const FastsimCreepages<Number>& creepages, double y) const {
        return {1 - y * y / (axes_.b * axes_.b), creepages.xi / L_.L1 - creepages.phi * y / L_.L3};
    }
    double half_chord(double rest) const;
    const Flexibilities& L() const { return L_; }

   private:
    template <class Number>
    FastsimTotals<Number> totals(const FastsimCreepages<Number>& creepages,
                                 const std::vector<SliceSums<Number>>& slices) const;

    SemiAxes axes_;
    Flexibilities L_;
    double bound_;
    std::shared_ptr<const FastsimNodes> nodes_;
};

}  // namespace contactd
