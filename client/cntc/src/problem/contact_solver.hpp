// Solves the cases of one contact problem. What stands behind it is the affair of this class.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"

namespace contactd::cntc {

/// Displacements of the upper body less those of the lower one (mm), an element each.
struct Displacements {
    std::vector<double> x, y, z;  ///< z of both bodies added: it parts them
};

class ContactSolver {
   public:
    /// Keeps the operators of the last problem, for the next one with the same elements, bodies and step. Throws
    /// InvalidArgument.
    ContactSolution solve(const ContactProblem& problem);
    Displacements displacements(const ContactProblem& problem, const ContactSolution& solution);

   private:
    /// The inputs that operators depend on, beside the step.
    struct Key {
        int nx, ny;
        double dx, dy;
        Bodies bodies;

        bool operator==(const Key&) const = default;
    };

    const ContactInfluence& influence_of(const ContactProblem& problem);

    std::optional<Key> key_;
    std::array<double, 3> step_{};  ///< of rolling_of_operators
    ContactInfluence influence_;
};

}  // namespace contactd::cntc
