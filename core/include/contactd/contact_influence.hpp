// From the bodies to the operators that solve their contact.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/ic_record.hpp"
#include "contactd/ic_table.hpp"
#include "contactd/influence_operator.hpp"
#include "contactd/observer.hpp"
#include "contactd/step_operator.hpp"

namespace contactd {

struct ContactInfluence {
    std::shared_ptr<const InfluenceOperator> current;  ///< A: displacements at the elements
    /// A - A' of rolling: by how much they differ from those one step ahead; null otherwise.
    std::shared_ptr<const StepOperator> increment;
    /// Warnings of the tables behind the operators, for users of a solution: sentences.
    std::vector<std::string> warnings{};

    std::size_t bytes() const;  ///< about what they take in memory
};

/// About what the operators of these bodies take, with that of rolling, which a step may ask for.
std::size_t influence_bytes(const Grid& grid, const Bodies& bodies);

/// `pair` holds the coefficients of both bodies (pair_of), or those given of the pair; a rigid body has none. Where one
/// has layers and rolls, the other's must be analytic, too; else give them one by one. Throws Cancelled when the
/// observer says so: coefficients one step ahead of a large grid take some seconds.
ContactInfluence make_influence(const ContactProblem& problem, IcTable pair, const Observer& observer = {});

/// Makes the operators of the bodies one by one: their tables are added where they are of a kind, else their operators
/// (sum_of). That of a rigid body means nothing. Throws Cancelled.
ContactInfluence make_influence(const ContactProblem& problem, BodyTable upper, BodyTable lower,
                                const Observer& observer = {});

/// Sums the operators of bodies whose tables are of unlike kinds and cannot be added: products with both, xz, yz, zx
/// and zy of the upper body subtracted from those of the lower. A body without operators is rigid. Throws
/// InvalidArgument when both are, or when their operators are on different grids.
ContactInfluence sum_of(const ContactInfluence& upper, const ContactInfluence& lower);

}  // namespace contactd
