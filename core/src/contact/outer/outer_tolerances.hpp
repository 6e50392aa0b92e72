// Tolerances of the outer (Panagiotopoulos) iterations between normal and tangential contact, and when these end.
#pragma once

#include "contactd/contact_setup.hpp"

namespace contactd {

/// Each outer iteration changes the tractions by a part of what the last one did. To solve it much better is wasted:
/// the next one has other pressures. So tolerances follow the change that is expected, and never rise. The last
/// iteration that is allowed has the tolerances of the problem: its tractions are the answer, converged or not.
class OuterTolerances {
   public:
    /// `loose`: false where all iterations are solved as the problem asks for.
    OuterTolerances(const ContactSetup& setup, bool loose);

    const SolverSettings& normal() const { return normal_; }
    const SolverSettings& tangential() const { return tangential_; }
    /// Whether they are those of the problem.
    bool are_final() const;
    /// Takes the relative change of the tractions by an iteration.
    void follow(double change);
    /// The relative change that is left, as the last two iterations tell; the last change where they do not, or where
    /// the limit made the last one exact beside others that were not.
    double left() const;

   private:
    bool next_is_last_allowed() const;

    const ContactSetup& setup_;
    const bool loose_;
    SolverSettings normal_, tangential_;
    int iterations_ = 0;
    bool is_forced_ = false, was_forced_ = false;  // to the problem's tolerances by the limit: the next one, the last
    double change_ = 0, rate_ = 1;                 // of the last iteration, and over that of the one before
    double sure_rate_ = 1;                         // the smaller one of the last two rates
};

}  // namespace contactd
