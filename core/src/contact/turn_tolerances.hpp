// How exactly normal and tangential contact are solved in their turns between bodies that differ, and when these end.
#pragma once

#include "contactd/contact_setup.hpp"

namespace contactd {

/// Each turn changes the tractions by a part of what the last one did. To solve it much better than that is wasted: the
/// next turn has other pressures. So tolerances follow the change that is expected, and never rise.
class TurnTolerances {
   public:
    /// `loose`: false where all turns are solved as the problem asks for.
    TurnTolerances(const ContactSetup& setup, bool loose);

    const SolverSettings& normal() const { return normal_; }
    const SolverSettings& tangential() const { return tangential_; }
    /// Whether they are those of the problem.
    bool are_final() const;
    /// A turn has changed the tractions by that much, relative.
    void follow(double change);
    /// What is left to change, relative, as far as the last two turns tell; the last change where they do not.
    double left() const;

   private:
    const ContactSetup& setup_;
    const bool loose_;
    SolverSettings normal_, tangential_;
    double change_ = 0, rate_ = 1;  // of the last turn, to that of the turn before
    double sure_rate_ = 1;          // the smaller one of the last two rates
};

}  // namespace contactd
