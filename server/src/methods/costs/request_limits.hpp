// Checks limits of a request before memory of its size is allocated. `params` have been checked against their schema.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/proto/message.hpp"
#include "solves/small_solve.hpp"

namespace contactd::server {

/// Throws StatusError (LIMIT_EXCEEDED) when params.grid has more than `most` elements.
void check_grid_limit(const nlohmann::json& params, std::size_t most);
/// Checks the grids of all problems together.
void check_grid_limits(const nlohmann::json& problems, std::size_t most);

/// Lists the arrays of a solution to be sent.
struct ArrayAnswer {
    SolutionFields fields;
    std::size_t elements = 0;  ///< of the grid
};
/// Returns the arrays in the answer of contact.solve, from params within the limit of grids; there is no slip without
/// friction.
ArrayAnswer array_answer(const nlohmann::json& params);

/// Throws StatusError (ANSWER_TOO_LARGE) if the arrays do not fit into one message, so that the problem need not be
/// solved. The size of lists is unknown in advance, so they are checked when they are sent.
void check_answer_fits(std::span<const ArrayAnswer> answers, proto::ArrayEncoding arrays, const MessageLimits& limits);

}  // namespace contactd::server
