// Computes costs in memory and time that several methods have, from the arguments of a request. MethodTable has a cost
// for each expensive method; a cost of a single method is next to its handler. docs/limits.md is generated from them,
// and a test compares them with measurements.
#pragma once

#include <nlohmann/json.hpp>

#include "config/config.hpp"
#include "jobs/work_budget.hpp"

namespace contactd::server {

/// All require params that have been checked against their schema, and throw StatusError (LIMIT_EXCEEDED) for a grid
/// beyond limits.max_grid_elements.
WorkCost cost_of_solve(const nlohmann::json& params, const Config& config);
/// Returns the cost of all problems together: their answers, and one of the largest problems for each worker.
WorkCost cost_of_solve_many(const nlohmann::json& params, const Config& config);
WorkCost cost_of_table(const nlohmann::json& params, const Config& config);
WorkCost cost_of_export(const nlohmann::json& params, const Config& config);
/// Returns the cost of a patch of the usual size; larger ones are checked when they are found.
WorkCost cost_of_wheel_rail(const nlohmann::json& params, const Config& config);

/// Returns whether the work takes longer than a second and must leave a worker to small work.
bool is_large(double seconds);

/// Throws StatusError (LIMIT_EXCEEDED), with the cost and the limit, for work that may not begin at all.
void check_cost(const WorkCost& cost, const Config& config);

}  // namespace contactd::server
