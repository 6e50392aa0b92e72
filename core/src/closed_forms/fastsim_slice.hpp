// FASTSIM's march through one slice of the contact area (Kalker 1982).
#pragma once

#include <algorithm>
#include <cmath>

#include "dual.hpp"
#include "fastsim.hpp"

namespace contactd {

// `Number` is double, or Dual where derivatives by the creepages are wanted.
template <class Number>
struct FastsimCreepages {
    Number xi, eta, phi;  // in the rolling frame
};

template <class Number>
struct TractionAt {
    Number x, px, py;
};

// One slice y = constant of the contact area, followed from its leading edge backwards.
template <class Number>
class FastsimSlice {
   public:
    using Traction = TractionAt<Number>;

    FastsimSlice(const SemiAxes& axes, const Flexibilities& L, double bound, const FastsimCreepages<Number>& creepages,
                 double y)
        : rest_(1 - y * y / (axes.b * axes.b)),
          half_chord_(axes.a * std::sqrt(rest_)),
          bound_(bound),
          curvature_(1 / (axes.a * axes.a)),
          slope_x_(creepages.xi / L.L1 - creepages.phi * y / L.L3),
          slope_y_(creepages.eta / L.L2),
          slope_yx_(creepages.phi / L.L3),
          stiff_x_(0.5 * (L.L1 + L.L2) / L.L1),
          stiff_y_(0.5 * (L.L1 + L.L2) / L.L2),
          x_(half_chord_) {}

    double half_chord() const { return half_chord_; }
    double x() const { return x_; }
    Number px() const { return px_; }
    Number py() const { return py_; }
    bool slips() const { return slips_; }
    Number slope_x() const { return slope_x_; }                                 // rigid slip over L1
    Number slope_y(const Number& x) const { return slope_y_ + slope_yx_ * x; }  // and over L2
    Number slope_yx() const { return slope_yx_; }
    // What took the trial traction beyond the bound, per length: the slip is -L times this.
    Number excess_x() const { return excess_x_; }
    Number excess_y() const { return excess_y_; }
    Number bound_at(const Number& x) const { return bound_ * std::max(Number(0.0), rest_ - x * x * curvature_); }
    // Where in the last step slip began: at its beginning, its end (only adhesion), or between.
    Number slip_start() const { return slip_start_; }

    Traction here() const { return {x_, px_, py_}; }

    void step_to(double x) {
        using std::sqrt;
        const double h = x_ - x;
        const Number old_room = room_;
        const bool adhered = !slips_;
        const Traction trial = adhering(here(), x);
        const Number g = bound_at(x), size = sqrt(trial.px * trial.px + trial.py * trial.py);
        slip_start_ = x_;
        x_ = x;
        px_ = trial.px;
        py_ = trial.py;
        slips_ = size > g;
        room_ = slips_ ? Number(0) : g - size;
        excess_x_ = excess_y_ = 0;
        if (!slips_) slip_start_ = x;
        if (!slips_) return;
        if (adhered) slip_start_ -= h * old_room / (old_room + size - g);
        return_to_bound(g, size);
        excess_x_ = (trial.px - px_) / h;
        excess_y_ = (trial.py - py_) / h;
    }

    // The traction at x if all adheres from there on: exact, since its slope is linear in x.
    Traction adhering(const Traction& from, const Number& x) const {
        const Number h = from.x - x;
        return {x, from.px - h * slope_x_, from.py - h * slope_y(0.5 * (from.x + x))};
    }

   private:
    // From the trial traction t to |p| = g with the slip, -L (t - p)/h, opposite to p: p_i = t_i/(1 + m/L_i), m >= 0.
    // One step of Newton's method for m, on 1/|p|, then scaling to g: exact for equal flexibilities and in full slip.
    void return_to_bound(const Number& g, const Number& trial) {
        using std::sqrt;
        if (g <= Number(0)) {
            px_ = py_ = 0;
            return;
        }
        const Number t2 = trial * trial, slope = px_ * px_ * stiff_x_ + py_ * py_ * stiff_y_;
        const Number m = t2 * (trial - g) / (g * slope);
        px_ *= 1 + m * stiff_y_;
        py_ *= 1 + m * stiff_x_;
        const Number back = g / sqrt(px_ * px_ + py_ * py_);
        px_ *= back;
        py_ *= back;
    }

    double rest_, half_chord_, bound_, curvature_;
    Number slope_x_, slope_y_, slope_yx_;
    double stiff_x_, stiff_y_;
    double x_;
    Number px_ = 0, py_ = 0, room_ = 0, excess_x_ = 0, excess_y_ = 0;
    Number slip_start_ = 0;
    bool slips_ = false;
};

}  // namespace contactd
