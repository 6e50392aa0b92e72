#include "rail_case.hpp"

#include <algorithm>

#include "answers/rail_patch.hpp"
#include "edge/codes.hpp"
#include "edge/last_error.hpp"
#include "given/given_friction.hpp"
#include "problem/rail_setup.hpp"

namespace contactd::cntc {
namespace {

/// Keeps the curves of the profiles if at most the friction has changed, as it may from step to step.
void use(RailCase& rail, const WheelRailSetup& setup) {
    if (rail.contact) {
        if (rail.contact->setup() == setup) return;
        WheelRailSetup same = setup;
        same.friction = rail.contact->setup().friction;
        if (same.friction && setup.friction && rail.contact->setup() == same) {
            rail.contact = std::make_unique<const WheelRailContact>(rail.contact->with_friction(*setup.friction));
            return;
        }
    }
    rail.contact.reset();
    rail.contact = std::make_unique<const WheelRailContact>(setup);
}

void require_all_converged(const WheelRailSolution& solution) {
    const auto missed = [](const std::optional<SolverEvidence>& search) { return search && !search->converged; };
    const std::string kept = " The best solution found is kept.";
    for (const WheelRailPatch& patch : solution.patches) require_converged(patch.solution.evidence);
    if (missed(solution.force))
        throw Refused(error_code::total_force, "No height of the wheelset produces the vertical force." + kept);
    if (missed(solution.pitch_search))
        throw Refused(error_code::total_force, "No pitch rate produces the longitudinal force." + kept);
    if (missed(solution.rail_search))
        throw Refused(error_code::total_force, "No equilibrium of the massless flexible rail was found." + kept);
}

GivenMotion creepages_of(const Motion& motion) {
    if (const auto* rolling = std::get_if<Rolling>(&motion)) return {rolling->xi, rolling->eta, rolling->phi};
    const auto& shift = std::get<Shift>(motion);
    return {shift.rigid_shift.x, shift.rigid_shift.y, shift.rotation};
}

/// A prescribed force requires contact; a prescribed height does not.
void require_contact(const RailCase& rail) {
    if (rail.solution->in_contact() || !rail.state->Fz) return;
    const auto& warnings = rail.solution->warnings;
    throw Refused(error_code::search, warnings.empty() ? "Wheel and rail do not touch." : warnings.back());
}

}  // namespace

const WheelRailSolution& solution_of(const RailCase& rail) {
    if (!rail.current) throw Refused(error_code::input, "There is no solution. Call cntc_calculate and check ierror.");
    return *rail.solution;
}

void calculate(RailCase& rail, const Settings& common) {
    rail.current = false;
    require_nothing_refused(common);
    require_nothing_refused(rail.settings);
    const WheelRailSetup setup = setup_of(common, rail.settings);
    warn_of_memory(common);
    if (setup.friction)
        if (const auto sentence = warning_of_places(*common.friction, rail.settings.position.x); !sentence.empty())
            warn(sentence);
    const WheelRailState state = state_of(common, rail.settings);
    use(rail, setup);
    if (common.digits.result >= 2) return;
    Observer observer;
    rail.solution = rail.history.solve(common, rail.contact->setup().model, state, [&](WheelRailEstimates& estimates) {
        return rail.contact->solve(state, estimates, observer);
    });
    rail.state = state;
    rail.current = true;
    require_contact(rail);
    require_all_converged(*rail.solution);
}

std::vector<const WheelRailPatch*> ordered_patches(const RailCase& rail) {
    std::vector<const WheelRailPatch*> patches;
    for (const WheelRailPatch& patch : solution_of(rail).patches) patches.push_back(&patch);
    if (rail.contact->setup().side == Side::left) std::ranges::reverse(patches);
    return patches;
}

const RailOutlines& outlines_of(RailCase& rail, const Settings& common) {
    WheelRailSetup setup = rail.current ? rail.contact->setup() : outline_of(common, rail.settings);
    setup.friction.reset();
    if (!rail.outlines || rail.outlines->setup != setup) {
        geometry::Profiles profiles = geometry::make_profiles(setup);
        rail.outlines = std::make_shared<const RailOutlines>(RailOutlines{std::move(setup), std::move(profiles)});
    }
    return *rail.outlines;
}

RailFrames frames_of(RailCase& rail, const Settings& common) {
    const WheelRailState state =
        rail.current ? found_state(*rail.state, *rail.solution) : placed_state(common, rail.settings);
    return frames_of(outlines_of(rail, common), state);
}

void show(const WheelRailPatch& patch, const RailCase& rail, const Settings& common, ProblemCase& problem) {
    // The arrays of the previous step are reused for this one.
    if (!problem.solved) problem.solved.emplace();
    const Motion motion = show_patch(patch, rail.contact->setup(), *rail.state, *problem.solved);
    std::map<int, GivenBlock> blocks = std::move(problem.settings.blocks);
    problem.settings = common;
    problem.settings.blocks = std::move(blocks);
    problem.settings.digits.force = 0;
    problem.settings.area = problem.solved->problem.grid;
    problem.settings.pen.reset();
    problem.settings.motion = creepages_of(motion);
    problem.settings.velocity = patch.place.creepages.velocity;
    problem.blocks.clear();
    problem.current = true;
}

}  // namespace contactd::cntc
