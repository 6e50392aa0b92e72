// How exactly normal and tangential contact are solved in their turns between bodies that differ.
#pragma once

#include <optional>

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

   private:
    const ContactSetup& setup_;
    SolverSettings normal_, tangential_;
    std::optional<double> last_change_;
};

}  // namespace contactd
