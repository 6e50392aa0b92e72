// contact.*: problems solved, and stresses under what was solved.
#include "all_methods.hpp"
#include "request_limits.hpp"
#include "solves/contact_solve.hpp"
#include "solves/contact_subsurface.hpp"

namespace contactd::server {

using nlohmann::json;

namespace {

void solve(const CallPtr& call, const DaemonParts& parts) {
    const proto::Request& request = call->request;
    check_grid_limit(request.params, parts.config.max_grid_elements);
    check_answer_fits({&request.params}, request.arrays, parts.config.limits);
    ++parts.counters.solves;
    start_solve(call, parts.solve_tools());
}

void solve_many(const CallPtr& call, const DaemonParts& parts) {
    const json& problems = call->request.params.at("problems");
    check_grid_limits(problems, parts.config.max_grid_elements);
    std::vector<const json*> each;
    for (const json& problem : problems) each.push_back(&problem);
    check_answer_fits(each, call->request.arrays, parts.config.limits);
    parts.counters.solves += static_cast<long long>(problems.size());
    start_solve_many(call, parts.solve_tools(), parts.config.workers, parts.config.limits);
}

void subsurface(const CallPtr& call, const DaemonParts& parts) {
    check_grid_limit(call->request.params, parts.config.max_grid_elements);
    answer_subsurface(call, parts.jobs, parts.config.limits);
}

}  // namespace

void add_contact_methods(MethodTable& methods) {
    methods.add({.name = "contact.solve", .job = "solve", .handle = solve});
    methods.add({.name = "contact.solve_many", .priority = proto::Priority::low, .job = "solve", .handle = solve_many});
    methods.add({.name = "contact.subsurface", .job = "subsurface", .handle = subsurface});
}

}  // namespace contactd::server
