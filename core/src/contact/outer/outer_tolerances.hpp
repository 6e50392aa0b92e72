// Selects tolerances of the outer (Panagiotopoulos) iterations between normal and tangential contact, and their end.
#pragma once

#include "contactd/contact_setup.hpp"

namespace contactd {

/// Each outer iteration changes the tractions by a fraction of the previous change. A much more accurate solve is
/// wasted, because the next one has other pressures. Therefore, tolerances follow the expected change, and never
/// increase. The last allowed iteration has the tolerances of the problem, because its tractions are the answer,
/// converged or not.
class OuterTolerances {
   public:
    /// If `loose` is false, all iterations have the problem's tolerances.
    OuterTolerances(const ContactSetup& setup, bool loose);

    const SolverSettings& normal() const { return normal_; }
    const SolverSettings& tangential() const { return tangential_; }
    /// Returns whether the present tolerances are those of the problem.
    bool are_final() const;
    /// Updates the tolerances after an iteration with this relative change of the tractions.
    void follow(double change);
    /// Returns the remaining relative change, extrapolated from the last two iterations. Returns the last change if
    /// these do not allow it, or if the limit made only the last iteration exact.
    double left() const;

   private:
    bool next_is_last_allowed() const;

    const ContactSetup& setup_;
    const bool loose_;
    SolverSettings normal_, tangential_;
    int iterations_ = 0;
    // They are set if the limit imposes the problem's tolerances on the next, and on the last iteration.
    bool is_forced_ = false, was_forced_ = false;
    double change_ = 0, rate_ = 1;  // change in the last iteration, and its ratio to the previous one
    double sure_rate_ = 1;          // smaller one of the last two rates
};

}  // namespace contactd
