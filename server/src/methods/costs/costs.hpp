// Costs in memory and time that several methods have, from the arguments of a request. MethodTable has a cost for each
// method whose work is not little; one that no other method has stands beside its handler. docs/limits.md is made from
// them, and a test compares them with what a daemon takes.
#pragma once

#include <nlohmann/json.hpp>

#include "config/config.hpp"
#include "jobs/work_budget.hpp"

namespace contactd::server {

/// All are of params that have passed their schema, and throw StatusError (LIMIT_EXCEEDED) for a grid beyond
/// limits.max_grid_elements.
WorkCost cost_of_solve(const nlohmann::json& params, const Config& config);
/// The cost of all problems together: their answers, and as many of the largest as there are workers.
WorkCost cost_of_solve_many(const nlohmann::json& params, const Config& config);
WorkCost cost_of_table(const nlohmann::json& params, const Config& config);
WorkCost cost_of_export(const nlohmann::json& params, const Config& config);
/// The cost of a patch of the usual size; larger ones are checked where they are found.
WorkCost cost_of_wheel_rail(const nlohmann::json& params, const Config& config);

/// Work that takes longer than a second must leave a worker to what is small.
bool is_large(double seconds);

/// Throws StatusError (LIMIT_EXCEEDED), with the figure and the limit, for what may not begin at all.
void check_cost(const WorkCost& cost, const Config& config);

}  // namespace contactd::server
