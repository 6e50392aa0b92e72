// Solves the cases of one contact problem. What stands behind it is the affair of this class.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "wheel_rail/patches/half_space_cache.hpp"

namespace contactd::cases {

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
    /// Those of a plane patch of a wheel on its rail, to the last bit as the solve of the wheel has them, which sees
    /// left wheels in a mirror.
    Displacements displacements_on_rail(const ContactProblem& problem, const ContactSolution& solution, bool is_left);

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
    std::optional<Bodies> bodies_on_rail_{};
    std::unique_ptr<HalfSpaceCache> on_rail_{};  ///< of these bodies
};

}  // namespace contactd::cases
