// A contact problem, the influence operators it needs, and its solution.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "contactd/contact.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"
#include "contactd/shifted_operator.hpp"

namespace contactd {

struct ContactInfluence {
    std::shared_ptr<const InfluenceOperator> here;  ///< displacements at the elements
    /// Of rolling: by how much they differ from those one step ahead (change_over_step); null otherwise.
    std::shared_ptr<const ShiftedOperator> change;

    std::size_t bytes() const;  ///< about what they take in memory
};

/// The way from a particle to where it was one step ago (mm): dq (cos chi, sin chi); zero unless the bodies roll.
std::array<double, 2> step_of(const ContactProblem& problem);

/// `pair` holds the coefficients of both bodies (pair_of), or those given by the problem; a rigid body has none.
ContactInfluence make_influence(const ContactProblem& problem, const IcTable& pair);

/// Normal contact and, where the problem has friction, tangential contact, by the problem's model; the full one needs
/// the operators. A solution that missed a tolerance says so in its evidence. Throws InvalidArgument when the problem
/// is invalid or the operators are of another grid, and Cancelled.
ContactSolution solve_contact(const ContactProblem& problem, const ContactInfluence& influence, Observer& observer);

}  // namespace contactd
