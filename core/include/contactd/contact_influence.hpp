// From the bodies to the operators that solve their contact.
#pragma once

#include <cstddef>
#include <memory>

#include "contactd/contact.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/step_operator.hpp"

namespace contactd {

struct ContactInfluence {
    std::shared_ptr<const InfluenceOperator> here;  ///< displacements at the elements
    /// Of rolling: by how much they differ from those one step ahead; null otherwise.
    std::shared_ptr<const StepOperator> change;

    std::size_t bytes() const;  ///< about what they take in memory
};

/// About what the operators for that many elements take, with that of rolling, which a step may ask for.
std::size_t influence_bytes(std::size_t elements);

/// `pair` holds the coefficients of both bodies (pair_of), or those given of the pair; a rigid body has none.
ContactInfluence make_influence(const ContactProblem& problem, IcTable pair);

}  // namespace contactd
