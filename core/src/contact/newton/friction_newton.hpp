// Solves Coulomb's law by Newton's method, for any slip of the form s = w + K p.
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

// Each iteration requires one product K p. The linear equations are never solved: each step combines the previous steps
// by least squares with one of the preconditioner, so that the iteration becomes GMRES once the division is stable. K
// need not be symmetric, because the method neither minimises a function nor uses conjugacy.
//
// If forces are prescribed, w has an unknown uniform part. It is constant until the law is nearly met; then forces and
// law are solved together.
class FrictionNewton {
   public:
    // `contact` may get other bounds and another rigid slip between solves, but no other elements. `flow` is the law of
    // a layer that hardens, or null; it must outlive this object.
    FrictionNewton(Compliance& compliance, const Contact& contact, const std::optional<ForcesGiven>& forces = {},
                   const FlowLaw* flow = nullptr);

    // Starts from an estimate, of which zero tractions mean none. `rigid` is the uniform part of w, which the contact
    // does not include.
    void start(const Field& estimate, const Pair& rigid = Pair::Zero());
    // Continues with other bounds or another rigid slip of the contact, and possibly other forces along the same
    // components. It starts from the present tractions and steps.
    void go_on(const std::optional<ForcesGiven>& forces);
    // Makes at most `iterations` iterations. Returns true if converged: law and forces hold to the tolerance, and the
    // fraction of elements that changed last between adhesion and slip does not exceed it either. Ends early without
    // progress.
    bool iterate(int iterations, const SolverSettings& settings, Observer& observer);
    const SolverEvidence& evidence() const { return evidence_; }

    const Field& tractions() const { return p_; }
    const Field& slip() const { return s_; }
    const std::vector<char>& slips() const { return law_.slips; }
    bool flows(std::size_t e) const { return flow_ && flow_->flows()[e] != 0; }
    const Pair& rigid() const { return rigid_; }
    // Returns the missing part of the forces, over the largest force that friction carries.
    double force_residual() const;

   private:
    static constexpr double on_bound = 1e-9;  // elements within this relative distance from the bound count as on it

    double size(std::size_t e) const;
    void take_bounds();
    void begin();
    void hold_rigid_slips(const ForcesGiven& forces);
    void update_slip();
    void let_slip(std::size_t e);
    void oppose_slip(std::size_t e);
    std::size_t find_division();  // returns how many tractions moved to their bounds
    double moved() const;
    double relative_step() const;
    void take_rigid_slip();
    void report(double law_residual, const SolverSettings& settings, Observer& observer);

    // Lets the rigid slip change, too, from here on.
    void join_forces();
    // Computes tangents, tangent stiffness, residual and violation at the present tractions.
    void linearise();
    // Applies the Jacobian to the previous steps; to all of them if the division or the tangents have changed.
    void linearise_history();
    bool division_stands(double tolerance) const;
    // Returns the residual of the law, and of prescribed forces.
    double residual() const;
    // Computes the next step in step_ and rigid_step_: the best combination of the previous steps, which leaves rest_
    // and rest_missing_ of the residual, plus one of the preconditioner.
    void find_step();
    void combine_steps();
    void complete_step();
    // Moves the tractions by the step and to their bounds, and updates the division and the slip.
    void take_step(double tolerance);
    // Returns, after combine_steps(), whether the combination alone is expected to meet the tolerance. Its slip is
    // known without a product.
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
    Pair missing_ = Pair::Zero();             // missing part of the forces
    Pair rest_missing_ = Pair::Zero();        // weighted as below
    double violation_ = 0;                    // violation of the law, root mean square over that of w
    double rms_w_ = 0;                        // root mean square of w, including its uniform part
    double squared_bound_ = 0, largest_ = 0;  // sums of g^2 and g
    double force_weight_ = 0;                 // gives errors of the forces the same weight as those of the law
    std::size_t changed_ = 0;                 // elements that changed in the last step
    bool has_step_ = false;                   // whether step_ belongs to the present tractions
    bool is_stale_ = false;                   // whether the images of the steps are outdated
    double relative_change_ = 0;              // relative change of the tractions since the history was linearised
    double best_ = std::numeric_limits<double>::infinity(), first_ = 0;
    int without_progress_ = 0;
};

}  // namespace contactd
