// Creates the operators of a contact from its bodies.
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
    /// In rolling, `increment` is A - A', where A' maps to displacements one step ahead. It is null otherwise.
    std::shared_ptr<const StepOperator> increment;
    /// Holds warnings of the tables behind the operators as sentences, for users of a solution.
    std::vector<std::string> warnings{};

    std::size_t bytes() const;  ///< approximate memory
};

/// Returns the approximate memory of the operators of these bodies, including that of rolling.
std::size_t influence_bytes(const Grid& grid, const Bodies& bodies);

/// Creates the operators from `pair`, the coefficients of both bodies (pair_of) or those given of the pair; a rigid
/// body has none. If one body has layers and rolls, the other's table must be analytic, too; otherwise pass the tables
/// one by one. Throws Cancelled, because coefficients one step ahead on a large grid take some seconds.
ContactInfluence make_influence(const ContactProblem& problem, IcTable pair, const Observer& observer = {});

/// Creates the operators from separate bodies: adds their tables if these are of one kind, otherwise their operators
/// (sum_of). The table of a rigid body is not used. Throws Cancelled.
ContactInfluence make_influence(const ContactProblem& problem, BodyTable upper, BodyTable lower,
                                const Observer& observer = {});

/// Sums the operators of bodies whose tables are of different kinds and cannot be added. Products are computed with
/// both, and xz, yz, zx and zy of the upper body are subtracted from those of the lower. A body without operators is
/// rigid. Throws InvalidArgument if both are rigid, or if their operators are on different grids.
ContactInfluence sum_of(const ContactInfluence& upper, const ContactInfluence& lower);

}  // namespace contactd
