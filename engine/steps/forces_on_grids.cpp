#include "forces_on_grids.hpp"

#include "contactd/closed_form_record.hpp"
#include "contactd/extrapolate_forces.hpp"
#include "contactd/ic_store.hpp"
#include "contactd/solve_contact.hpp"
#include "engine/ics/problem_tables.hpp"

namespace contactd::engine {

void extrapolate_on_grids(const ContactProblem& problem, ContactSolution& solution, InfluenceCache& cache,
                          Observer& observer) {
    extrapolate_forces(problem, solution, [&](const ContactProblem& on_grid) {
        observer.throw_if_cancelled();
        const IcSpec spec = *specs_of(on_grid)[0];  // Both bodies have the same material.
        const std::string key = ic_key(spec);
        const CachedInfluence operators = cache.of(influence_key(on_grid, key, key), [&] {
            const BodyTable table = body_table(closed_form_record(spec, observer), spec, 1, observer);
            return make_influence(on_grid, table, table, observer);
        });
        return solve_contact(on_grid, operators.influence, observer);
    });
}

}  // namespace contactd::engine
