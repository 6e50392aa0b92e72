// Solves the cases of one contact problem, and keeps their operators.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/contact_influence.hpp"
#include "wheel_rail/patches/half_space_cache.hpp"

namespace contactd::cases {

/// Holds displacements of the upper body minus those of the lower body (mm), one for each element.
struct Displacements {
    std::vector<double> x, y, z;  ///< z is the sum for both bodies, which separates them
};

class ContactSolver {
   public:
    /// Solves a problem. Keeps its operators for later problems with the same elements, bodies and step. Throws
    /// InvalidArgument.
    ContactSolution solve(const ContactProblem& problem);
    /// Returns the displacements of the surfaces.
    Displacements displacements(const ContactProblem& problem, const ContactSolution& solution);
    /// Returns the displacements of a planar patch of a wheel on its rail, equal to the last bit to those of the solve
    /// of the wheel, which mirrors left wheels.
    Displacements displacements_on_rail(const ContactProblem& problem, const ContactSolution& solution, bool is_left);

   private:
    /// Holds the inputs that operators depend on, except for the step.
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
