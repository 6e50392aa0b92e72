// Defines answers of contact.solve and contact.solve_many.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "contactd/contact.hpp"
#include "contactd/ic_reply.hpp"
#include "contactd/status.hpp"

namespace contactd {

/// Describes operators that are larger than the memory for all operators. Only the last ones used are kept.
struct OperatorUse {
    bool made = false;             ///< whether they were created for this solve; otherwise kept from an earlier one
    std::size_t bytes = 0;         ///< approximate memory
    std::size_t budget_bytes = 0;  ///< store.influence_budget_bytes

    bool operator==(const OperatorUse&) const = default;
};

struct SolveReply {
    ContactSolution solution;
    IcUses ics;                              ///< origin of its coefficients
    std::optional<OperatorUse> operators{};  ///< if they exceed the budget
};

/// Holds the solution of each of many problems, or the reason why there is none.
using ReplyOrStatus = std::variant<SolveReply, Status>;

}  // namespace contactd
