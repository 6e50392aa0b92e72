// Answers of contact.solve and contact.solve_many.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "contactd/contact.hpp"
#include "contactd/ic_reply.hpp"
#include "contactd/status.hpp"

namespace contactd {

/// Operators that are larger than what is kept of all operators together: those used last are kept alone.
struct OperatorUse {
    bool made = false;             ///< for this solve; else they were kept from one before
    std::size_t bytes = 0;         ///< about what they take in memory
    std::size_t budget_bytes = 0;  ///< store.influence_budget_bytes

    bool operator==(const OperatorUse&) const = default;
};

struct SolveReply {
    ContactSolution solution;
    IcUses ics;                              ///< where its coefficients came from
    std::optional<OperatorUse> operators{};  ///< where they exceed the budget
};

/// Each of many problems has its solution, or says why there is none.
using ReplyOrStatus = std::variant<SolveReply, Status>;

}  // namespace contactd
