// Implements the iteration of NORM on the elements of one influence operator.
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
    std::span<const double> distance;    // h, minus the approach if that is prescribed
    std::optional<double> pressure_sum;  // prescribed instead of the approach, > 0
    bool estimate_only = false;          // whether to end when residual and violations together are below the tolerance
};

// Minimises f(p) = p'Ap/2 + h'p over p >= 0 and, if it is prescribed, sum(p) = const. The optimality conditions are the
// contact conditions, and the approach is the multiplier of the sum. Preconditioned conjugate gradients run on the
// contact set. When they have reduced the residual enough, negative pressures leave the set and elements that overlap
// enter it. Monitoring f prevents endless changes of the set.
class Norm {
   public:
    Norm(const InfluenceOperator& influence, const NormProblem& problem, const SolverSettings& settings,
         Observer& observer);
    virtual ~Norm() = default;

    // Sets the estimate and returns its distance from a solution, in the measure of the stopping criterion. With
    // `set_is_good`, the elements with pressure are the best guess of the contact, because the estimate is too rough to
    // show overlaps.
    double start(std::span<const double> estimate, bool set_is_good);
    // Continues with another distance, near that of the present solution, or another sum if one is prescribed. Starts
    // from the present solution, extrapolated along the previous change if there was one.
    void go_on(const NormProblem& problem, const SolverSettings& settings, Observer& observer);
    SolverEvidence solve();

    const std::vector<double>& pressure() const { return p_; }
    double approach() const { return approach_; }  // 0 if it was prescribed

   protected:
    using Values = std::vector<double>;
    static constexpr double rounding = 1e-14;

    // Holds the contact conditions at the present pressures; squares are sums over elements, in mm^2.
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
    /// Monitors f, and returns false if it has moved the pressures.
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
    const double self_;     // the largest influence of an element on itself, which converts suction to a displacement
    Values p_, u_;          // u = A p
    Values r_, z_, v_, q_;  // residual, preconditioned; direction, q = A v
    Values in_contact_;     // 1 in the contact set, 0 outside
    Values weight_;         // about A^-1 1 on the set: effect of a change of the approach on the pressures
    // Counts the elements of the set that have changed since the weights were computed.
    double changed_elements_ = std::numeric_limits<double>::infinity();
    double approach_ = 0;
    Check check_;  // conditions at the present pressures
    bool set_is_good_ = false;
    // Violations larger than this fraction of the defect change the set. Smaller ones wait until the iteration has
    // reduced the defect, because every change restarts it.
    double weighty_ = 0.1;
    Values last_p_, last_u_;  // solution for the previous distance, or empty
    Values best_p_, best_u_;
    double best_f_ = std::numeric_limits<double>::infinity();  // lowest at a change of the set
    int failures_ = 0;
    double curvature_ = 0;
    int steps_ = 0;  // steps since the last change of the set
    double norm_of_A_ = 0;
    double first_residual_ = 0;
};

}  // namespace contactd
