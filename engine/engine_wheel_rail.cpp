// Solves wheels on rails with the engine.
#include <string>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "contactd/patch_influence.hpp"
#include "contactd/proto/status.hpp"
#include "contactd/strip_frames.hpp"
#include "contactd/strip_memory.hpp"
#include "engine/engine.hpp"
#include "engine/ics/problem_tables.hpp"

namespace contactd::engine {
namespace {

/// Tables are somewhat larger than needed, because the next patch may be larger.
int rounded_up(int count) {
    constexpr int step = 32;
    return (count + step - 1) / step * step;
}

/// Returns a key for half-spaces that rotate from row to row. Positions of a wheel that differ in x only have the same
/// rows.
std::string rotated_key(const ContactProblem& problem, const PatchStrips& strips) {
    std::string key = influence_key(problem, "rotated", "");
    for (const StripFrame& frame : strips.frames)
        for (const double value : {frame.y, frame.z, frame.angle})
            key.append(reinterpret_cast<const char*>(&value), sizeof value);
    return key;
}

/// Checks here, because grids are determined with the contacts.
void check_patch(const Grid& grid, std::size_t most) {
    if (grid.size() > most)
        throw proto::invalid_field("setup.dx",
                                   "and dy result in a patch of " + std::to_string(grid.size()) +
                                       " elements, but at most " + std::to_string(most) +
                                       " are allowed (limits.max_grid_elements)",
                                   proto::reason::limit_exceeded);
}

/// Limits the memory, which grows with the pairs of rows if coefficients differ between rows.
void check_rows(const ContactProblem& problem, const PatchStrips& strips, std::size_t most_bytes) {
    const Grid& grid = problem.grid;
    const double elements = static_cast<double>(grid.size()), pairs = elements * grid.ny;
    double bytes = rotated_bytes(elements, pairs);
    if (strips.of_sections()) {
        const auto [rail, wheel] = problem.bodies.materials();
        // Tables of sections are extracted from larger ones.
        const int tables = (rail.is_rigid() ? 0 : 1) + (wheel.is_rigid() ? 0 : 1) + 1;
        bytes = strip_bytes(pairs, tables, strip_rolling(step_of(problem)[0] / grid.dx));
    }
    if (bytes > static_cast<double>(most_bytes))
        throw proto::invalid_field(
            "setup.dy",
            "results in a curved patch of " + std::to_string(grid.ny) + " rows of " + std::to_string(grid.nx) +
                " elements, which requires about " + std::to_string(static_cast<long long>(bytes)) +
                " bytes, but at most " + std::to_string(most_bytes) +
                " are allowed (limits.max_work_bytes): use longer elements, or conformal half_space",
            proto::reason::limit_exceeded);
}

void check_half_spaces(const Bodies& bodies) {
    for (const auto& [body, field] : {std::pair(&bodies.upper, "upper"), std::pair(&bodies.lower, "lower")}) {
        const Ics* ics = body->computed();
        const bool elsewise = !body->material.is_rigid() && (ics == nullptr || *ics != Ics{});
        if (bodies.pair || elsewise)
            throw InvalidArgument(std::string("bodies.") + field,
                                  "is not a half-space in closed form, the only body that wheel-rail contact supports");
    }
}

/// Reports errors with the field names of the request, before anything is built.
void check_section(const IcSpec& spec, const std::string& name) {
    try {
        validate(spec);
        strip_frames(spec);
    } catch (const InvalidArgument& error) {
        throw InvalidArgument("conformal",
                              "is fem, but the cross-section of the " + name + " cannot be used: " + error.what());
    }
}

/// Warns of operators beyond their budget at the patch that is solved with them, even if an earlier solve of the height
/// search computed them.
ContactInfluence with_warnings(CachedInfluence cached) {
    if (cached.use) cached.influence.warnings.push_back(operator_warning(*cached.use));
    return std::move(cached.influence);
}

/// Returns the result of `solve` and renames refused fields of the set-up to fields below `setup`; the core names those
/// of a state "state.".
template <class Solve>
auto below_setup(const std::string& setup, const Solve& solve) {
    return renaming([&](const std::string& field) { return field.starts_with("state.") ? field : setup + "." + field; },
                    solve);
}

/// Returns the result of `solve` for a wheelset. It refuses fields of one wheel's set-up as those of the set-up of
/// both, unless the left wheel has its own.
template <class Solve>
auto below_setups(bool left_has_own, const Solve& solve) {
    return renaming(
        [&](const std::string& field) {
            if (left_has_own && field.starts_with("left.")) return field;
            return in_place_of("left.", "setup.")(in_place_of("right.", "setup.")(field));
        },
        solve);
}

}  // namespace

/// Gets tables as contact.solve does: from memory, from the store, or by a build for which the thread waits.
ContactInfluence Engine::sections_influence(const ContactProblem& problem, const PatchStrips& strips,
                                            Observer& observer) {
    const auto table_of = [&](const std::optional<BodyStrips>& body, const char* name) {
        if (!body) return IcAnswer{};
        check_section(body->spec, name);
        return fetch(body->spec, observer);
    };
    const auto key_of = [](const IcAnswer& answer, const std::optional<BodyStrips>& body) {
        return body ? answer.cache_key() + " from " + std::to_string(body->first) : answer.cache_key();
    };
    const IcAnswer rail = table_of(strips.rail, "rail"), wheel = table_of(strips.wheel, "wheel");
    const std::string key = influence_key(problem, key_of(rail, strips.rail), key_of(wheel, strips.wheel));
    const auto make = [&] {
        ContactInfluence influence =
            contactd::patch_influence(problem, strips, rail.record.get(), wheel.record.get(), observer);
        influence.warnings = table_warnings({wheel, rail});
        return influence;
    };
    return with_warnings(influences_.of(key, make));
}

ContactInfluence Engine::patch_influence(const ContactProblem& problem, const PatchStrips& strips, Observer& observer) {
    check_patch(problem.grid, settings_.most_patch_elements);
    if (!strips.flat() && !strips.along_loaded_row) check_rows(problem, strips, settings_.most_patch_bytes);
    if (strips.of_sections()) return sections_influence(problem, strips, observer);
    if (!strips.flat())
        return with_warnings(influences_.of(rotated_key(problem, strips), [&] {
            if (strips.along_loaded_row) return contactd::patch_influence(problem, strips, nullptr, nullptr, observer);
            return rotated_patches_.of(problem, strips, observer);
        }));
    ContactSetup larger = problem;
    larger.grid.nx = rounded_up(problem.grid.nx);
    larger.grid.ny = rounded_up(problem.grid.ny);
    return with_warnings(influence_of(problem, fetch(larger, observer), influences_, observer));
}

WheelRailSolution Engine::solve(const WheelRailSetup& setup, const WheelRailState& state, Observer& observer) {
    below("state", [&] { validate(setup, state); });
    WheelRailSolution solution =
        below_setup("setup", [&] { return wheel_on_rail(setup, observer)->solve(state, observer); });
    count(solution);
    return solution;
}

WheelRailSolution Engine::solve(const WheelRailSetup& setup, const WheelRailState& state, WheelRailEstimates& estimates,
                                Observer& observer) {
    below("state", [&] { validate(setup, state); });
    WheelRailSolution solution =
        below_setup("setup", [&] { return wheel_on_rail(setup, observer)->solve(state, estimates, observer); });
    count(solution);
    return solution;
}

WheelsetSolution Engine::solve(const WheelsetSetup& setup, const WheelsetState& state, Observer& observer) {
    WheelsetEstimates none;
    return solve(setup, state, none, observer);
}

WheelsetSolution Engine::solve(const WheelsetSetup& setup, const WheelsetState& state, WheelsetEstimates& estimates,
                               Observer& observer) {
    validate_below("state", state);
    const auto contact = [&](Side side) {
        const bool own = side == Side::left && setup.left;
        return below(own ? "left" : "setup", [&] { return wheel_on_rail(setup_of(setup, side), observer); });
    };
    const PreparedContacts::Contact right = contact(Side::right), left = contact(Side::left);
    WheelsetSolution solution =
        below_setups(setup.left.has_value(), [&] { return solve_wheelset(*left, *right, state, estimates, observer); });
    count(solution.left);
    count(solution.right);
    return solution;
}

std::unique_ptr<WheelRailSteps> Engine::open(const WheelRailSessionSpec& spec, const Observer& observer) {
    return below("setup", [&] {
        return std::make_unique<WheelRailSteps>(wheel_on_rail(spec.setup, observer), spec.accept_unconverged);
    });
}

WheelRailSolution Engine::solve(WheelRailSteps& steps, const StepState& before, const WheelRailStepInput& input,
                                StepState& after, Observer& observer) {
    validate_below("state", input.state);
    const WheelRailContact& contact = steps.contact_with(input.friction);
    WheelRailSolution solution =
        below_setup("setup", [&] { return steps.solve(contact, before, input.state, after, observer); });
    count(solution);
    return solution;
}

PreparedContacts::Contact Engine::wheel_on_rail(const WheelRailSetup& setup, const Observer& observer) {
    check_half_spaces(setup.bodies);
    return wheels_on_rails_.of(setup, observer);
}

void Engine::count(const WheelRailSolution& solution) {
    for (const WheelRailPatch& patch : solution.patches) {
        check_patch(patch.place.grid,
                    settings_.most_patch_elements);  // Simplified models request no operators.
        count(patch.solution);
    }
}

std::vector<WheelRailGeometry> Engine::locate(const WheelRailSetup& setup, std::span<const WheelRailState> states,
                                              Observer& observer) {
    const PreparedContacts::Contact contact = below("setup", [&] { return wheels_on_rails_.of(setup, observer); });
    std::vector<WheelRailGeometry> geometries;
    for (const WheelRailState& state : states) {
        const std::string name = "states[" + std::to_string(geometries.size()) + "]";
        validate_below(name, state);
        geometries.push_back(renaming(in_place_of("state", name), [&] {
            return below_setup("setup", [&] { return contact->locate(state, observer); });
        }));
        Progress progress;
        progress.stage = "search";
        progress.fraction = static_cast<double>(geometries.size()) / static_cast<double>(states.size());
        observer.on_progress(progress);
        observer.throw_if_cancelled();
    }
    return geometries;
}

}  // namespace contactd::engine
