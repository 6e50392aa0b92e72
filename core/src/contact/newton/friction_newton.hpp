// Newton's method on Coulomb's law, for all that slips by s = w + K p.
#pragma once

#include <limits>
#include <vector>

#include "compliance.hpp"
#include "contact/support/contact_elements.hpp"
#include "contactd/contact.hpp"
#include "contactd/observer.hpp"
#include "secant_history.hpp"

namespace contactd {

// One product K p an iteration. The linear equations are never solved: each step combines the steps made so far by
// least squares with one of the preconditioner, so that the iteration becomes GMRES once the division stands. K need
// not be symmetric: nothing is minimised, and there is no conjugacy.
class FrictionNewton {
   public:
    FrictionNewton(Compliance& compliance, const Contact& contact, const SolverSettings& settings, Observer& observer);

    void start(const Field& estimate);
    // At most `iterations`; true when converged. Ends early when it makes no more progress.
    bool iterate(int iterations);
    const SolverEvidence& evidence() const { return evidence_; }

    const Field& tractions() const { return p_; }
    const Field& slip() const { return s_; }
    const std::vector<char>& slips() const { return law_.slips; }

   private:
    double size(std::size_t e) const;
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
    // Tractions after the step, brought to their bounds; the division and the slip with them.
    void take_step();
    bool made_progress();

    Compliance& compliance_;
    const Contact& contact_;
    const std::vector<double>& g_;
    const Field& w_;
    const SolverSettings& settings_;
    Observer& observer_;
    const std::size_t m_;
    const double rms_w_;
    SecantHistory history_;
    Linearisation law_;
    SolverEvidence evidence_;
    Field p_, s_, r_, rest_, step_, z_;
    std::vector<char> before_;  // the division before the last step
    std::vector<double> inverse_g_;
    double squared_bound_;  // sum of g^2
    bool division_changed_ = false;
    double turned_ = 0;  // relative change of the tractions since the history was linearised
    double best_ = std::numeric_limits<double>::infinity(), first_ = 0;
    int without_progress_ = 0;
};

}  // namespace contactd
