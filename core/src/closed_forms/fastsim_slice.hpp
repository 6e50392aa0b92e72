// FASTSIM's march through one slice of the contact area (Kalker 1982).
#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>

#include "fastsim.hpp"

namespace contactd {

struct FastsimCreepages {
    double xi, eta, phi;  // in the rolling frame
};

struct TractionAt {
    double x, px, py;
};

// One slice y = constant of the contact area, followed from its leading edge backwards.
class FastsimSlice {
   public:
    FastsimSlice(const SemiAxes& axes, const Flexibilities& L, double bound, const FastsimCreepages& creepages,
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
    double px() const { return px_; }
    double py() const { return py_; }
    bool slips() const { return slips_; }
    double slope_x() const { return slope_x_; }                          // rigid slip over L1
    double slope_y(double x) const { return slope_y_ + slope_yx_ * x; }  // and over L2
    double slope_yx() const { return slope_yx_; }
    // What took the trial traction beyond the bound, per length: the slip is -L times this.
    double excess_x() const { return excess_x_; }
    double excess_y() const { return excess_y_; }
    double bound_at(double x) const { return bound_ * std::max(0.0, rest_ - x * x * curvature_); }
    // Where in the last step slip began: at its beginning, its end (only adhesion), or between.
    double slip_start() const { return slip_start_; }

    TractionAt here() const { return {x_, px_, py_}; }

    void step_to(double x) {
        const double h = x_ - x, old_room = room_;
        const bool adhered = !slips_;
        const TractionAt trial = adhering({x_, px_, py_}, x);
        const double g = bound_at(x), size = std::sqrt(trial.px * trial.px + trial.py * trial.py);
        slip_start_ = x_;
        std::tie(x_, px_, py_) = std::tie(trial.x, trial.px, trial.py);
        slips_ = size > g;
        room_ = slips_ ? 0 : g - size;
        excess_x_ = excess_y_ = 0;
        if (!slips_) slip_start_ = x;
        if (!slips_) return;
        if (adhered) slip_start_ -= h * old_room / (old_room + size - g);
        return_to_bound(g, size);
        excess_x_ = (trial.px - px_) / h;
        excess_y_ = (trial.py - py_) / h;
    }

    // The traction at x if all adheres from there on: exact, since its slope is linear in x.
    TractionAt adhering(const TractionAt& from, double x) const {
        const double h = from.x - x;
        return {x, from.px - h * slope_x_, from.py - h * slope_y(0.5 * (from.x + x))};
    }

   private:
    // From the trial traction t to |p| = g with the slip, -L (t - p)/h, opposite to p: p_i = t_i/(1 + m/L_i), m >= 0.
    // One step of Newton's method for m, on 1/|p|, then scaling to g: exact for equal flexibilities and in full slip.
    void return_to_bound(double g, double trial) {
        if (g <= 0) {
            px_ = py_ = 0;
            return;
        }
        const double t2 = trial * trial, slope = px_ * px_ * stiff_x_ + py_ * py_ * stiff_y_;
        const double m = t2 * (trial - g) / (g * slope);
        px_ *= 1 + m * stiff_y_;
        py_ *= 1 + m * stiff_x_;
        const double back = g / std::sqrt(px_ * px_ + py_ * py_);
        px_ *= back;
        py_ *= back;
    }

    double rest_, half_chord_, bound_, curvature_, slope_x_, slope_y_, slope_yx_, stiff_x_, stiff_y_;
    double x_, px_ = 0, py_ = 0, room_ = 0, excess_x_ = 0, excess_y_ = 0;
    double slip_start_ = 0;
    bool slips_ = false;
};

}  // namespace contactd
