// NORM, the iteration itself, on the elements of one influence operator.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"
#include "norm_loops.hpp"

namespace contactd {

struct NormProblem {
    std::span<const double> distance;    // h, with the approach subtracted where that is prescribed
    std::optional<double> pressure_sum;  // prescribed instead of the approach, > 0
    bool estimate_only = false;          // ends when residual and violations together are below the tolerance
};

// Minimises f(p) = p'Ap/2 + h'p over p >= 0, where prescribed also over sum(p) = const. The optimality conditions are
// the contact conditions, the approach is the multiplier of the sum. Preconditioned conjugate gradients on the contact
// set; when they have brought the residual down to where it matters, negative pressures leave the set and elements that
// overlap enter it. A watch on f keeps the set from changing for ever.
class Norm {
   public:
    Norm(const InfluenceOperator& influence, const NormProblem& problem, const SolverSettings& settings,
         Observer& observer);
    virtual ~Norm() = default;

    // Takes the estimate and returns how far it is from a solution, in the measure of the stopping criterion.
    // `set_is_good`: the elements with pressure are the best guess of the contact, for the estimate is too rough to
    // show overlaps.
    double start(std::span<const double> estimate, bool set_is_good);
    // Another distance, near the last one whose solution this has, or another sum where one is prescribed: goes on from
    // there, along the change before where there was one.
    void go_on(const NormProblem& problem, const SolverSettings& settings, Observer& observer);
    SolverEvidence solve();

    const std::vector<double>& pressure() const { return p_; }
    double approach() const { return approach_; }  // 0 where it was prescribed

   protected:
    using Values = std::vector<double>;
    static constexpr double rounding = 1e-14;

    // The contact conditions at the present pressures; squares are sums over elements, in mm^2.
    struct Check {
        double defect = 0, reference = 0;
        double suction = 0;  // violation of p >= 0, times the influence of an element on itself
        double overlap = 0;  // violation of gap >= 0 outside
        bool right_set() const { return suction == 0 && overlap == 0; }
        double relative(double square) const { return reference > 0 ? std::sqrt(square / reference) : 0; }
        double residual() const { return relative(defect); }
        double error() const { return relative(defect + suction + overlap); }
    };

    NormState state() { return {n_, in_contact_.data(), h_.data(), p_.data(), u_.data(), r_.data()}; }
    double gap(std::size_t i) const { return u_[i] + h_[i] - approach_; }
    bool overlaps(std::size_t i) const;
    void take_multiple_of(std::span<const double> estimate);
    void scale_to_sum(Values& p, Values& u) const;
    void find_approach();
    Check advance(double alpha);
    bool good_enough(const Check& check, int iteration) const;
    virtual bool change_set(Check check, bool change_all);
    void clip();
    /// Looks at f, and returns false where it has moved the pressures.
    virtual bool watch();
    void projected_gradient_step();
    virtual double choose_step();
    void go_along_last_change();
    void weigh_sum();
    void keep_sum_of_residual();
    void keep_sum_of_direction();
    void report(int iteration, double residual);

    const InfluenceOperator& influence_;
    NormProblem problem_;
    std::span<const double> h_;
    SolverSettings settings_;
    Observer* observer_;
    const std::size_t n_;
    const double self_;     // the largest influence of an element on itself: turns suction into a displacement
    Values p_, u_;          // u = A p
    Values r_, z_, v_, q_;  // residual, preconditioned; direction, q = A v
    Values in_contact_;     // 1 in the contact set, 0 outside
    Values weight_;         // about A^-1 1 on the set: what a change of the approach does to the pressures
    double changed_elements_ = std::numeric_limits<double>::infinity();  // of the set since the weights were found
    double approach_ = 0;
    Check check_;  // at the present pressures
    bool set_is_good_ = false;
    // Violations larger than this part of the defect change the set; smaller ones wait until the iteration, which
    // starts again with every change, has brought the defect down.
    double weighty_ = 0.1;
    Values last_p_, last_u_;  // the solution for the distance before, or empty
    Values best_p_, best_u_;
    double best_f_ = std::numeric_limits<double>::infinity();  // lowest at a change of the set
    int failures_ = 0;
    double curvature_ = 0;
    int steps_ = 0;  // since the last change of the set
    double norm_of_A_ = 0;
    double first_residual_ = 0;
};

}  // namespace contactd
