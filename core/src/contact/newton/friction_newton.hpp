// Newton's method on Coulomb's law, for all that slips by s = w + K p.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "compliance.hpp"
#include "contact/support/contact_elements.hpp"
#include "contactd/contact.hpp"
#include "contactd/observer.hpp"
#include "force_border.hpp"
#include "plastic_flow.hpp"
#include "secant_history.hpp"

namespace contactd {

// One product K p an iteration. The linear equations are never solved: each step combines the steps made so far by
// least squares with one of the preconditioner, so that the iteration becomes GMRES once the division stands. K need
// not be symmetric: nothing is minimised, and there is no conjugacy.
//
// Where forces are given, w has a uniform part that is unknown. It stays as it is until the law is nearly met, then
// forces and law are solved at once.
class FrictionNewton {
   public:
    // `contact` may get other bounds and another rigid slip between solves, but no other elements.
    // `flow` is the law of a layer that hardens, which outlives this, or null.
    FrictionNewton(Compliance& compliance, const Contact& contact, const std::optional<ForcesGiven>& forces = {},
                   const FlowLaw* flow = nullptr);

    // Zero tractions are no estimate. `rigid` is the uniform part of w, which is not in the contact's.
    void start(const Field& estimate, const Pair& rigid = Pair::Zero());
    // The contact has other bounds or another rigid slip, and the forces along the same components may be others: goes
    // on from the tractions as they are, and with the steps made so far.
    void go_on(const std::optional<ForcesGiven>& forces);
    // At most `iterations`; true when converged: law and forces hold to the tolerance, and no larger part of the
    // elements than that has just changed between adhesion and slip. Ends early when it makes no more progress.
    bool iterate(int iterations, const SolverSettings& settings, Observer& observer);
    const SolverEvidence& evidence() const { return evidence_; }

    const Field& tractions() const { return p_; }
    const Field& slip() const { return s_; }
    const std::vector<char>& slips() const { return law_.slips; }
    bool flows(std::size_t e) const { return flow_ && flow_->flows()[e] != 0; }
    const Pair& rigid() const { return rigid_; }
    // Returns the missing part of the forces, over the largest that friction carries.
    double force_residual() const;

   private:
    static constexpr double on_bound = 1e-9;  // relative distance from the bound that counts as being on it

    double size(std::size_t e) const;
    void take_bounds();
    void begin();
    void hold_rigid_slips(const ForcesGiven& forces);
    void update_slip();
    void let_slip(std::size_t e);
    void oppose_slip(std::size_t e);
    std::size_t find_division();  // how many tractions moved to their bounds
    double moved() const;
    double relative_step() const;
    void take_rigid_slip();
    void report(double law_residual, const SolverSettings& settings, Observer& observer);

    // From here on the rigid slip changes, too.
    void join_forces();
    // Tangents, tangent stiffness, residual and violation at the present tractions.
    void linearise();
    // Applies the Jacobian to the steps made so far; to all of them when the division or the tangents have changed.
    void linearise_history();
    bool division_stands(double tolerance) const;
    // Returns the residual of the law, and of the forces where they are prescribed.
    double residual() const;
    // The next step, into step_ and rigid_step_: the best combination of the steps made so far, which leaves rest_ and
    // rest_missing_ of the residual, and one of the preconditioner.
    void find_step();
    void combine_steps();
    void complete_step();
    // Tractions after the step, brought to their bounds; the division and the slip with them.
    void take_step(double tolerance);
    // After combine_steps(): whether the combination alone is expected to meet the tolerance. Its slip is known without
    // a product.
    bool combination_is_enough(double tolerance) const;
    void take_combination(double tolerance);
    void move();
    void count_changes();
    bool made_progress();

    Compliance& compliance_;
    const Contact& contact_;
    const std::vector<double>& g_;
    const Field& w_;
    const std::size_t m_;
    std::optional<ForceBorder> border_;
    bool joined_ = false;
    SecantHistory history_;
    Linearisation law_;
    std::optional<PlasticFlow> flow_;
    SolverEvidence evidence_;
    Field p_, s_, slip_of_, r_, rest_, step_, z_;  // s is the slip of slip_of
    Field last_s_;                                 // before the last step
    Pair rigid_ = Pair::Zero(), rigid_step_ = Pair::Zero();
    std::vector<char> before_, flowed_;  // the division before the last step
    std::vector<double> inverse_g_;
    Pair missing_ = Pair::Zero();             // of the forces
    Pair rest_missing_ = Pair::Zero();        // weighted as below
    double violation_ = 0;                    // of the law, root mean square over that of w
    double rms_w_ = 0;                        // root mean square of w, with its uniform part
    double squared_bound_ = 0, largest_ = 0;  // sums of g^2 and g
    double force_weight_ = 0;                 // makes errors of the forces weigh as those of the law
    std::size_t changed_ = 0;                 // elements, in the last step
    bool has_step_ = false;                   // step_ is for the tractions as they are
    bool is_stale_ = false;                   // what the Jacobian makes of the steps
    double relative_change_ = 0;              // relative change of the tractions since the history was linearised
    double best_ = std::numeric_limits<double>::infinity(), first_ = 0;
    int without_progress_ = 0;
};

}  // namespace contactd
