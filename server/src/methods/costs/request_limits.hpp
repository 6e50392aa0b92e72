// Limits that a request has to keep to before anything of its size is made. `params` have passed their schema.
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

/// The arrays of a solution that are sent.
struct ArrayAnswer {
    SolutionFields fields;
    std::size_t elements = 0;  ///< of the grid
};
/// The arrays that contact.solve answers, from params that keep to the limit of grids; there is no slip without
/// friction.
ArrayAnswer array_answer(const nlohmann::json& params);

/// Throws StatusError (ANSWER_TOO_LARGE) when the arrays could not be sent in one message: what could not be sent need
/// not be solved. Lists have no size that is known before; they are checked when they go.
void check_answer_fits(std::span<const ArrayAnswer> answers, proto::ArrayEncoding arrays, const MessageLimits& limits);

}  // namespace contactd::server
