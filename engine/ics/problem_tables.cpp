#include "problem_tables.hpp"

#include <algorithm>
#include <utility>

#include "contactd/ic_exchange.hpp"
#include "contactd/section_warnings.hpp"
#include "contactd/version.hpp"
#include "ic_import.hpp"

namespace contactd::engine {
namespace {

/// Uses the instantaneous response of a body: tables are elastic, and operators add the effect of creep.
std::optional<IcSpec> spec_of(const ContactSetup& setup, const Body& body) {
    const Ics* ics = body.computed();
    if (ics == nullptr) return {};
    const Grid& grid = setup.grid;
    return IcSpec{*ics, without_instant_creep({body, body}).upper.material, grid.dx, grid.dy, grid.nx, grid.ny};
}

BodyTable table_of(const ContactSetup& setup, const Body& body, const IcAnswer& answer, const Observer& observer) {
    const Grid& grid = setup.grid;
    if (const GivenIcs* given = body.given()) return cropped(given->table, grid.nx, grid.ny);
    if (const auto spec = spec_of(setup, body)) return body_table(*answer.record, *spec, 1, observer);
    return IcTable(grid.nx, grid.ny);
}

void check_tables(const ContactSetup& setup) {
    if (!needs_tables(setup)) return;
    const auto specs = specs_of(setup);
    if (specs[0]) validate(*specs[0], "bodies.upper");
    if (specs[1]) validate(*specs[1], "bodies.lower");
}

IcUse use_of(const GivenIcs& given) {
    IcUse use{"given", ic_key(given), {}};
    use.evidence.source = "table";
    use.evidence.version = "contactd " + version();
    return use;
}

std::optional<IcUse> use_of(const Body& body, const IcAnswer& answer) {
    if (const GivenIcs* given = body.given()) return use_of(*given);
    if (body.computed() == nullptr) return {};
    return IcUse{answer.origin, answer.key, answer.record->evidence};
}

}  // namespace

bool needs_tables(const ContactSetup& setup) {
    if (setup.model != Model::full || setup.bodies.pair) return false;
    return setup.bodies.upper.computed() != nullptr || setup.bodies.lower.computed() != nullptr;
}

std::array<std::optional<IcSpec>, 2> specs_of(const ContactSetup& setup) {
    return {spec_of(setup, setup.bodies.upper), spec_of(setup, setup.bodies.lower)};
}

void check(const ContactProblem& problem) {
    validate(problem);
    check_tables(problem);
}

void check_opening(const ContactProblem& problem) {
    validate_opening(problem);
    check_tables(problem);
}

CachedInfluence influence_of(const ContactProblem& problem, const IcAnswers& ics, InfluenceCache& cache,
                             const Observer& observer) {
    const Bodies& bodies = problem.bodies;
    if (problem.model != Model::full) return {};
    if (bodies.pair) return {make_influence(problem, bodies.pair->table, observer)};
    const auto make = [&] {
        ContactInfluence influence = make_influence(problem, table_of(problem, bodies.upper, ics[0], observer),
                                                    table_of(problem, bodies.lower, ics[1], observer), observer);
        influence.warnings = table_warnings(ics);
        return influence;
    };
    // Requests for several accuracies may share one table, so their warnings are not cached.
    CachedInfluence found = bodies.any_given()
                                ? CachedInfluence{make()}
                                : cache.of(influence_key(problem, ics[0].cache_key(), ics[1].cache_key()), make);
    for (std::string& warning : accuracy_warnings(bodies, ics)) found.influence.warnings.push_back(std::move(warning));
    return found;
}

IcUses uses_of(const ContactSetup& setup, const IcAnswers& ics) {
    IcUses uses;
    if (setup.model != Model::full) return uses;
    if (setup.bodies.pair) {
        uses.pair = use_of(*setup.bodies.pair);
        return uses;
    }
    uses.upper = use_of(setup.bodies.upper, ics[0]);
    uses.lower = use_of(setup.bodies.lower, ics[1]);
    return uses;
}

std::vector<std::string> accuracy_warnings(const Bodies& bodies, const IcAnswers& ics) {
    std::vector<std::string> result;
    for (const auto& [body, answer] : {std::pair(&bodies.upper, &ics[0]), std::pair(&bodies.lower, &ics[1])}) {
        const Ics* asked = body->computed();
        if (asked == nullptr || !answer->record || !answer->record->evidence.section) continue;
        for (std::string& warning : section_warnings(asked->accuracy, *answer->record->evidence.section))
            if (std::ranges::find(result, warning) == result.end()) result.push_back(std::move(warning));
    }
    return result;
}

std::vector<std::string> table_warnings(const IcAnswers& ics) {
    std::vector<std::string> result;
    const auto add = [&](std::string warning) {
        if (std::ranges::find(result, warning) == result.end()) result.push_back(std::move(warning));
    };
    for (const IcAnswer& answer : ics) {
        if (!answer.record) continue;
        const IcEvidence& evidence = answer.record->evidence;
        if (evidence.imported) add(imported_warning(answer.key));
        if (!evidence.modelling_error) continue;
        for (std::string& warning : modelling_warnings(answer.record->spec, *evidence.modelling_error))
            add(std::move(warning));
    }
    return result;
}

}  // namespace contactd::engine
