// FASTSIM's march through one slice of the contact area (Kalker 1982).
#pragma once

#include <algorithm>
#include <cmath>

#include "contactd/fastsim.hpp"

namespace contactd {

struct FastsimCreepages {
    double xi, eta, phi;  // in the rolling frame
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
    // What took the trial traction beyond the bound, per length: the slip is -L times this.
    double excess_x() const { return excess_x_; }
    double excess_y() const { return excess_y_; }
    // Where in the last step slip began, as a share of the step, and how far the traction was then from the straight
    // line between the ends of the step. Zero and none unless adhesion turned into slip.
    double slip_start() const { return slip_start_; }
    double corner_x() const { return corner_x_; }
    double corner_y() const { return corner_y_; }

    void step_to(double x) {
        const double h = x_ - x;
        const double old_x = px_, old_y = py_, old_room = room_;
        const bool adhered = !slips_;
        px_ -= h * slope_x_;
        py_ -= h * slope_y(0.5 * (x_ + x));  // exact: the slope is linear in x
        x_ = x;
        const double g = bound_ * std::max(0.0, rest_ - x * x * curvature_);
        const double trial = std::sqrt(px_ * px_ + py_ * py_);
        slips_ = trial > g;
        room_ = slips_ ? 0 : g - trial;
        excess_x_ = excess_y_ = corner_x_ = corner_y_ = 0;
        slip_start_ = slips_ ? 0 : 1;
        if (!slips_) return;
        if (adhered) slip_start_ = old_room / (old_room + trial - g);
        const double f = slip_start_, at_x = old_x + f * (px_ - old_x), at_y = old_y + f * (py_ - old_y);
        const double trial_x = px_, trial_y = py_;
        return_to_bound(g, trial);
        excess_x_ = (trial_x - px_) / h;
        excess_y_ = (trial_y - py_) / h;
        if (!adhered) return;
        corner_x_ = at_x - (old_x + f * (px_ - old_x));
        corner_y_ = at_y - (old_y + f * (py_ - old_y));
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
    double slip_start_ = 1, corner_x_ = 0, corner_y_ = 0;
    bool slips_ = false;
};

}  // namespace contactd
