// The direct iteration for steady rolling.
#pragma once

#include <limits>
#include <vector>

#include "contact/support/contact_elements.hpp"
#include "rolling.hpp"
#include "rolling_sweep.hpp"
#include "secant_history.hpp"

namespace contactd {

// Newton's method on the friction law for s = w + C p, with one product C p an iteration. The linear equations are
// never solved: each step combines the steps made so far by least squares with one of the preconditioner, so that the
// iteration becomes GMRES once the division stands. C is not symmetric, there is nothing to minimise and no conjugacy.
class SteadyRolling {
   public:
    SteadyRolling(const RollingBodies& bodies, const Contact& contact, const SolverSettings& settings,
                  Observer& observer);

    void start(const Field& estimate);
    // At most `iterations`; true when converged. Ends early when it makes no more progress.
    bool iterate(int iterations);
    const SolverEvidence& evidence() const { return evidence_; }

    const Field& tractions() const { return p_; }
    const Field& slip() const { return s_; }
    const std::vector<char>& slips() const { return law_.slips; }

   private:
    double size(std::size_t e) const;
    void apply(const Field& in, Field& out);
    void update_slip();
    void let_slip(std::size_t e);
    void find_division();
    double relative_step() const;
    void report(double residual);

    // Tangents, turning stiffness and residual at the present tractions.
    void linearise();
    // What the Jacobian makes of the steps made so far; of all of them when the division or the tangents have changed.
    void linearise_history();
    // Root mean square violation of the law over that of w.
    double violation() const;
    // The next step, into step_.
    void find_step();
    // z ~ J^-1 r. Where the contact has a leading edge but no trailing one, C = A T with T p = p(x) - p(x + step), and
    // C^-1 = T^-1 A^-1; where it has a trailing edge only it is A^-1 T^-1. Adhesion has both, and the mean of the two
    // serves it twice as well as either alone, the more so for the first step, whose residual is smooth up to the
    // edges. Slip does not care: where it prevails the two take turns.
    void precondition(const Field& r, Field& z);
    // q ~ A^-1 r where turning is easy, r over A's diagonal where it is not.
    void divide_by_influence(const Field& r, Field& q);
    // Tractions after the step, brought to their bounds; the division and the slip with them.
    void take_step();
    bool made_progress();

    const InfluenceOperator& influence_;
    const StepOperator& change_;
    const Contact& contact_;
    const std::vector<double>& g_;
    const Field& w_;
    const SolverSettings& settings_;
    Observer& observer_;
    const std::size_t m_;
    const std::vector<double> self_;  // of each element in contact, A's diagonal
    const double rms_w_;
    RollingSweep sweep_;
    SecantHistory history_;
    Linearisation law_;
    SolverEvidence evidence_;
    Field p_, s_, r_, rest_, step_, z_, swept_, full_in_, full_out_;
    std::vector<char> before_;               // the division before the last step
    std::vector<double> weight_, diagonal_;  // of A^-1 in the preconditioner and of what stands in for it, per element
    std::vector<double> inverse_g_;
    std::vector<double> stiff_, to_diagonal_;  // turning stiffness that rules the Jacobian; slip to traction of one
    double squared_bound_;                     // sum of g^2
    std::size_t slipping_ = 0;                 // elements
    bool division_changed_ = false;
    double turned_ = 0;  // relative change of the tractions since the history was linearised
    double best_ = std::numeric_limits<double>::infinity(), first_ = 0;
    int without_progress_ = 0;
};

}  // namespace contactd
