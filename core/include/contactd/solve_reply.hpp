// What contact.solve and contact.solve_many answer.
#pragma once

#include <variant>

#include "contactd/contact.hpp"
#include "contactd/ic_reply.hpp"
#include "contactd/status.hpp"

namespace contactd {

struct SolveReply {
    ContactSolution solution;
    IcUses ics;  ///< where its coefficients came from
};

/// Of many problems each has its solution, or says why there is none.
using ReplyOrStatus = std::variant<SolveReply, Status>;

}  // namespace contactd
