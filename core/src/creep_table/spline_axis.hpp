// Defines uniform cubic B-splines of one variable.
#pragma once

#include <algorithm>

namespace contactd::creep_table {

/// Describes the knots of a spline: n cells have n + 1 knots, which are also the nodes of a fit, and n + 3
/// coefficients.
struct SplineAxis {
    double from = 0, to = 1;
    int cells = 1;

    double step() const { return (to - from) / cells; }
    double node(int index) const { return index == cells ? to : from + index * step(); }
    int coefficients() const { return cells + 3; }
    bool contains(double x) const { return x >= from && x <= to; }
    /// Returns the cell of x. Values beyond the ends belong to the outermost cells.
    int cell(double x) const { return std::clamp(static_cast<int>((x - from) * (cells / (to - from))), 0, cells - 1); }
};

/// Holds the values and slopes at one point of the four B-splines that do not vanish there, whose coefficients are
/// those of `cell` and the next three.
template <class Real>
struct SplineWeights {
    int cell;
    Real value[4], slope[4];

    SplineWeights(const SplineAxis& axis, double x) {
        const double inverse = axis.cells / (axis.to - axis.from);
        const double position = std::clamp((x - axis.from) * inverse, 0.0, 1.0 * axis.cells);
        cell = std::min(static_cast<int>(position), axis.cells - 1);
        const double t = position - cell, s = 1 - t;
        value[0] = static_cast<Real>(s * s * s / 6);
        value[1] = static_cast<Real>((3 * t - 6) * t * t / 6 + 2.0 / 3);
        value[2] = static_cast<Real>((3 * s - 6) * s * s / 6 + 2.0 / 3);
        value[3] = static_cast<Real>(t * t * t / 6);
        slope[0] = static_cast<Real>(-s * s / 2 * inverse);
        slope[1] = static_cast<Real>((1.5 * t - 2) * t * inverse);
        slope[2] = static_cast<Real>((2 - 1.5 * s) * s * inverse);
        slope[3] = static_cast<Real>(t * t / 2 * inverse);
    }
};

}  // namespace contactd::creep_table
