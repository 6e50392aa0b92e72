// Computes FASTSIM's march through one slice of the contact area (Kalker 1982), or through four of them side by side.
#pragma once

#include <cmath>

#include "closed_forms/quad.hpp"
#include "types/simd.hpp"

namespace contactd {

// `Number` is Quad, or DualOf<Quad> for derivatives with respect to the creepages.
template <class Number>
struct FastsimCreepages {
    Number xi, eta, phi;  // in the rolling frame
};

// Holds values that all slices of a contact area share.
template <class Number>
struct FastsimLaw {
    double bound, curvature;   // the bound is bound (1 - curvature x^2 - y^2/b^2)
    Number slope_y, slope_yx;  // rigid slip across over L2: slope_y + slope_yx x
    double stiff_x, stiff_y;   // the mean flexibility over L1 and L2
};

// Describes a slice y = constant.
template <class Number>
struct FastsimSlice {
    Number rest;     // 1 - y^2/b^2
    Number slope_x;  // rigid slip along over L1
};

template <class Number>
struct TractionAt {
    Number x, px, py;
};

template <class Number>
using FastsimMask = decltype(Number{} > Number{});

// Describes the current point of the march through a slice, which begins at the leading edge with zeros.
template <class Number>
struct FastsimPoint {
    TractionAt<Number> traction;
    FastsimMask<Number> slips{};  // whether it slips or adheres
};

template <class Number>
struct FastsimStep {
    FastsimPoint<Number> end;
    Number slip_start;  // start of slip: the slice's beginning, its end (all adheres), or between
};

template <class Number>
CONTACTD_INLINE Number bound_at(const FastsimLaw<Number>& law, const FastsimSlice<Number>& slice, const Number& x) {
    const Number share = slice.rest - law.curvature * x * x, none{};
    return law.bound * chosen(share > none, share, none);
}

// Returns the traction at x if all adheres from there on. It is exact, since its slope is linear in x.
template <class Number>
CONTACTD_INLINE TractionAt<Number> adhering(const FastsimLaw<Number>& law, const FastsimSlice<Number>& slice,
                                            const TractionAt<Number>& from, const Number& x) {
    const Number h = from.x - x;
    return {x, from.px - h * slice.slope_x, from.py - h * (law.slope_y + law.slope_yx * (0.5 * (from.x + x)))};
}

// Returns the traction p from the trial traction t, so that |p| = g and the slip -L (t - p)/h is opposite to p: p_i =
// t_i/(1 + m/L_i), m >= 0. One step of Newton's method for m, on 1/|p|, then scaling to g is exact for equal
// flexibilities and in full slip. Divisors of branches not taken are 1, since the calling program may trap divisions by
// zero.
template <class Number>
CONTACTD_INLINE FastsimStep<Number> step(const FastsimLaw<Number>& law, const FastsimSlice<Number>& slice,
                                         const FastsimPoint<Number>& from, const Number& x) {
    using std::sqrt;
    const TractionAt<Number> t = adhering(law, slice, from.traction, x);
    const Number none{}, one(1), g = bound_at(law, slice, x), squared = t.px * t.px + t.py * t.py;
    const auto slips = squared > g * g;
    FastsimStep<Number> taken{{t, slips}, x};
    if (!any(slips)) return taken;

    const Number beyond = chosen(slips, Number(sqrt(squared) - g), none);
    taken.slip_start = chosen(slips, from.traction.x, x);
    if (const auto begins = slips & (slips ^ from.slips); any(begins)) {
        // Slip begins where the traction reaches its bound; both are taken as linear.
        const Number& px = from.traction.px;
        const Number& py = from.traction.py;
        const Number room = bound_at(law, slice, from.traction.x) - Number(sqrt(px * px + py * py));
        const Number free = chosen(room > none, room, none), crossed = chosen(begins, Number(free + beyond), one);
        const Number start = from.traction.x - (from.traction.x - x) * (free / crossed);
        taken.slip_start = chosen(begins, start, taken.slip_start);
    }
    const auto returns = chosen(slips, g, none) > none;
    const Number slope = chosen(returns, g * (t.px * t.px * law.stiff_x + t.py * t.py * law.stiff_y), one);
    const Number m = squared * beyond / slope;
    const Number px = t.px * (one + m * law.stiff_y), py = t.py * (one + m * law.stiff_x);
    const Number back = g / chosen(returns, Number(sqrt(px * px + py * py)), one);
    taken.end.traction.px = chosen(slips, Number(px * back), t.px);
    taken.end.traction.py = chosen(slips, Number(py * back), t.py);
    return taken;
}

// Holds integrals of p_x, p_y and x p_y along a slice, and the length that slips.
template <class Number>
struct SliceSums {
    Number px{}, py{}, x_py{}, slip{};
};

// Adds an interval by Simpson's rule, which is exact for cubics.
template <class Number>
CONTACTD_INLINE void add(const TractionAt<Number>& from, const TractionAt<Number>& middle, const TractionAt<Number>& to,
                         SliceSums<Number>& sum) {
    const Number unit = (1.0 / 6) * (from.x - to.x);
    sum.px += unit * (from.px + 4 * middle.px + to.px);
    sum.py += unit * (from.py + 4 * middle.py + to.py);
    sum.x_py += unit * (from.x * from.py + 4 * (middle.x * middle.py) + to.x * to.py);
}

// Advances by one step and adds it to the sums. A step adheres, slips, or does first one and then the other. The
// traction is a quadratic function of x in the part that adheres. In the part that slips, it follows the bound, a
// parabola, and its direction changes little: in the middle it is the bound in the mean direction.
template <class Number>
CONTACTD_INLINE FastsimPoint<Number> advance(const FastsimLaw<Number>& law, const FastsimSlice<Number>& slice,
                                             const FastsimPoint<Number>& from, const Number& x,
                                             SliceSums<Number>& sum) {
    using std::sqrt;
    const FastsimStep<Number> taken = step(law, slice, from, x);
    const Number& corner = taken.slip_start;
    TractionAt<Number> start = from.traction;
    const TractionAt<Number>& end = taken.end.traction;
    if (any(start.x > corner)) {
        const TractionAt<Number> turn = adhering(law, slice, start, corner);
        add(start, adhering(law, slice, start, Number(0.5 * (start.x + corner))), turn, sum);
        start = turn;
    }
    if (any(corner > x)) {
        const Number px = start.px + end.px, py = start.py + end.py, size = sqrt(px * px + py * py);
        const Number middle = 0.5 * (corner + x), none{}, one(1);
        const Number share = bound_at(law, slice, middle) / chosen(size > none, size, one);
        add(start, TractionAt<Number>{middle, share * px, share * py}, end, sum);
        sum.slip += corner - x;
    }
    return taken.end;
}

}  // namespace contactd
