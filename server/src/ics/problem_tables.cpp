#include "problem_tables.hpp"

#include "contactd/ic_exchange.hpp"
#include "contactd/version.hpp"

namespace contactd::server {
namespace {

IcSpec spec_of(const ContactProblem& problem, const Material& material) {
    const Grid& grid = problem.grid;
    return {problem.ics, material, grid.dx, grid.dy, grid.nx, grid.ny};
}

IcTable body_table(const ContactProblem& problem, const IcAnswer& answer, const Material& material) {
    const Grid& grid = problem.grid;
    if (material.is_rigid()) return IcTable(grid.nx, grid.ny);
    return table_of(answer, spec_of(problem, material));
}

}  // namespace

bool needs_tables(const ContactProblem& problem) {
    return problem.model == Model::full && !problem.given_ics;
}

std::array<std::optional<IcSpec>, 2> specs_of(const ContactProblem& problem) {
    std::array<std::optional<IcSpec>, 2> specs;
    const auto& [upper, lower] = problem.bodies;
    if (!upper.is_rigid()) specs[0] = spec_of(problem, upper);
    if (!lower.is_rigid()) specs[1] = spec_of(problem, lower);
    return specs;
}

void check(const ContactProblem& problem) {
    validate(problem);
    if (!needs_tables(problem)) return;
    const auto specs = specs_of(problem);
    if (specs[0]) validate_body(*specs[0], "bodies.upper");
    if (specs[1]) validate_body(*specs[1], "bodies.lower");
}

ContactInfluence influence_of(const ContactProblem& problem, const IcAnswers& ics, InfluenceCache& cache) {
    if (problem.model != Model::full) return {};
    if (problem.given_ics) return make_influence(problem, problem.given_ics->table);
    return cache.of(influence_key(problem, ics[0].key, ics[1].key), [&] {
        return make_influence(problem, pair_of(body_table(problem, ics[0], problem.bodies.upper),
                                               body_table(problem, ics[1], problem.bodies.lower)));
    });
}

IcUses uses_of(const ContactProblem& problem, const IcAnswers& ics) {
    IcUses uses;
    if (problem.model != Model::full) return uses;
    if (problem.given_ics) {
        uses.pair = {"given", ic_key(*problem.given_ics), {}};
        uses.pair->evidence.source = "table";
        uses.pair->evidence.version = "contactd " + version();
        return uses;
    }
    const auto use = [&](const IcAnswer& answer) {
        return proto::IcUse{answer.origin, answer.key, answer.record->evidence};
    };
    if (!problem.bodies.upper.is_rigid()) uses.upper = use(ics[0]);
    if (!problem.bodies.lower.is_rigid()) uses.lower = use(ics[1]);
    return uses;
}

}  // namespace contactd::server
