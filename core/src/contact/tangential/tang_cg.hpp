// Implements the iteration of TangCG (Zhao, Vollebregt, Oosterlee 2014; paper section 4.2).
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "contact/support/contact_elements.hpp"
#include "tangential.hpp"

namespace contactd {

// Runs nonlinear conjugate gradients: both components of the traction are free in adhesion, its direction is free in
// slip. If A is symmetric, the solution is the minimum of f(p) = p'Ap/2 + w'p over |p| <= g, and f safeguards the
// search.
class TangCg {
   public:
    TangCg(const InfluenceOperator& influence, const Contact& contact, const SolverSettings& settings,
           Observer& observer);

    // Starts from an estimate of the tractions.
    void start(const Field& estimate);
    TangentialSolution solve();

   private:
    void set_tractions(const Field& estimate);
    double size(std::size_t e) const { return std::sqrt(p_.x[e] * p_.x[e] + p_.y[e] * p_.y[e]); }
    double work(std::size_t e) const { return s_.x[e] * p_.x[e] + s_.y[e] * p_.y[e]; }

    // Scales the traction to its bound and returns the square of the change. A zero traction is set to oppose the rigid
    // slip; without rigid slip, the element stays in adhesion.
    double let_slip(std::size_t e);
    void apply(const Field& in, Field& out);
    // Computes s = A p + w.
    void update_slip_distance();
    double f() const { return 0.5 * (inner(p_, s_) + inner(p_, w_)); }
    double relative_to_traction(double change_squared) const;

    // Computes residual, normals and the tangent stiffness D = -(s . n)/g at the present tractions, and from them the
    // preconditioned residual z ~ (A + D)^-1 r, which estimates the error. The preconditioner is the operator's own,
    // scaled on both sides so that it stays symmetric and positive, where A dominates, the diagonal where D dominates,
    // and their mean in between.
    void linearise();

    // Makes one step; returns the relative change of the tractions.
    double step();
    // Returns (r, v).
    double choose_direction();
    // Computes p += alpha v, in slip scaled to the bound; the slip distance follows to first order.
    double move(double alpha);

    // Lets adhesion elements beyond the bound slip at once, because they spoil the search. Slip elements may adhere
    // only after the tractions have settled for some steps, since rough ones would release far too many.
    void update_division(double update);
    // Returns whether an element slips along the traction by more than rounding.
    bool is_pushed_back(std::size_t e) const { return slips_[e] && work(e) > noise_ * g_[e]; }
    bool any_pushed_back() const;
    std::size_t hold_pushed_back();
    // Recomputes the slip distance if scaling has changed the tractions by more than the remaining error of the
    // iteration.
    void refresh_if_stale(double update);

    // Keeps the tractions of the lowest f. If f has not decreased for several checks, a step that cannot increase it
    // restarts from them, and checks become more frequent. The slack grows each time, because tables with errors are
    // not quite symmetric, and the solution is then not quite the minimum.
    void watch();
    void keep_best();
    // Makes a step of at most 1/||A||: A_xy is at most half of A_xx, and the row sums of these bound the rest.
    void projected_gradient_step();

    void report(int iteration, double figure);
    void bring_to_bound(std::size_t e);
    void finish(TangentialSolution& result);

    const InfluenceOperator& influence_;
    const Contact& contact_;
    const std::vector<double>& g_;
    const Field& w_;
    const SolverSettings& settings_;
    Observer& observer_;
    const std::size_t m_;
    const std::vector<double> self_;     // A's diagonal of each element in contact
    std::vector<double> to_self_;        // the reciprocals
    double squared_bound_ = 0;           // sum of g^2
    double noise_ = 0;                   // of a slip distance
    Field p_, s_, r_, z_, v_, q_, jv_;   // q = A v, jv = J v with J the reduced Jacobian
    Field normal_, full_in_, full_out_;  // p/g in slip, 0 in adhesion
    std::vector<double> tangent_stiffness_, scale_, diagonal_,
        inverse_g_;  // D, and the preconditioner's factors for A and D
    std::vector<char> slips_;
    Field best_p_, best_s_;
    double best_f_ = std::numeric_limits<double>::infinity();
    double slack_ = 1e-12;
    double error_ = 0;      // estimated relative error of the tractions
    double drift_ = 0;      // relative change of the tractions that the slip distance does not include
    bool stands_ = true;    // whether the division did not change
    bool released_ = true;  // whether slip elements were checked for adhesion, too
    double curvature_ = 0;
    double first_figure_ = 0;
    int failures_ = 0;
    int steps_ = 0;               // steps in conjugate directions
    int steps_since_change_ = 0;  // steps since a change of the division, or since slip elements were checked
    int steps_since_refresh_ = 0;
    int steps_per_refresh_ = 8;  // largest number
};

}  // namespace contactd
