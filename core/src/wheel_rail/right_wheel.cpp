#include "wheel_rail/right_wheel.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "closed_forms/elements/element_friction.hpp"
#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "types/number_text.hpp"
#include "wheel_rail/balance.hpp"
#include "wheel_rail/differentiate.hpp"
#include "wheel_rail/flexible_rail.hpp"
#include "wheel_rail/off_tread.hpp"
#include "wheel_rail/patches/patch_solver.hpp"
#include "wheel_rail/patches/section_strips.hpp"
#include "wheel_rail/plausibility.hpp"
#include "wheel_rail/position/branch.hpp"
#include "wheel_rail/position/estimates.hpp"
#include "wheel_rail/resultants.hpp"
#include "wheel_rail/thin_data.hpp"
#include "wheel_rail/warnings.hpp"

namespace contactd {
namespace {

using geometry::CandidatePatch;

constexpr const char* nothing_below =
    "No part of the wheel is above the rail, so there is no contact. If this is unexpected, check position.y, "
    "track.gauge, flange_back_distance and flange_back_position of the wheelset, in mm.";

/// Adds sentences to an answer with warnings.
template <class Answer>
void warn(Answer& answer, std::vector<std::string> warnings) {
    for (std::string& warning : warnings) answer.warnings.push_back(std::move(warning));
}

ProfileFrame profile_frame(const geometry::Frame& frame) {
    const auto& [origin, axes] = frame;
    return {origin.x, origin.y, origin.z, std::atan2(-axes.z.y, axes.z.z), std::atan2(-axes.y.x, axes.x.x)};
}

constexpr double least_share = 0.2;  // share of the normal force in Fz, below which neither determines the other

/// Returns the deviation of a patch's answers from those with tight tolerances.
double accuracy_of(const ContactEvidence& evidence) {
    double accuracy = evidence.normal.residual / normal_per_accuracy;
    for (const auto& solver : {evidence.tangential, evidence.outer})
        if (solver) accuracy = std::max(accuracy, solver->residual / tangential_per_accuracy);
    return accuracy;
}

std::optional<double> share_of(const WheelRailPatch& patch) {
    if (!(patch.solution.forces.Fn > 0)) return std::nullopt;
    return patch.forces.track.Fz / patch.solution.forces.Fn;
}

/// A wheel that hardly rolls in a step, for example one that starts, slips as in a shift.
WheelRailState shifted_if_slow(const WheelRailSetup& setup, WheelRailState state) {
    constexpr double least_step = 1e-5;  // rolling step over an element's size
    if (state.motion != WheelRailMotion::transient_rolling || !state.time_step) return state;
    const double of_rim = std::abs(state.velocity.pitch) * setup.wheelset.nominal_radius;
    const double of_roller = std::abs(state.roller_pitch) * setup.track.roller_radius.value_or(0);
    const double speed = std::max({std::abs(state.velocity.x), of_rim, of_roller});
    if (speed * *state.time_step < least_step * setup.dx) state.motion = WheelRailMotion::shift;
    return state;
}

std::string falling_force(double z) {
    return "The vertical force decreases while the wheel is lowered near z = " + number_text(z) +
           " mm, for example because patches merge. Other heights may produce the same force, and a step may switch "
           "between them. Use smaller steps.";
}

std::string jumping_force(const HeightFound& found) {
    return "The vertical force jumps from " + short_text(found.jump->above) + " to " + short_text(found.jump->below) +
           " N at z = " + number_text(found.z) +
           " mm, where the set of elements or regions changes. The largest patch carries the difference. Use smaller "
           "elements for a smaller jump.";
}

std::string missed_force(double Fz, const HeightFound& found) {
    return "No height produces Fz = " + number_text(Fz) + " N: at z = " + number_text(found.z) +
           " mm the relative error of the force is " + short_text(found.evidence.residual) + " after " +
           std::to_string(found.evidence.iterations) + " solves.";
}

}  // namespace

RightWheel::RightWheel(const WheelRailSetup& setup, const geometry::Profiles& profiles,
                       const InfluenceSource& influences, const WheelRailState& state, const Observer& observer,
                       std::shared_ptr<const Patches> before)
    : setup_(setup),
      profiles_(profiles),
      influences_(influences),
      observer_(observer),
      state_(shifted_if_slow(setup, state)),
      position_(setup, profiles, state_, observer),
      before_(std::move(before)) {}

WheelRailSolution RightWheel::solve(Observer& observer) {
    WheelRailSolution solution;
    if (first_contact_height()) {
        below("state", [&] { check_height_or_force(state_); });
        if (state_.Fx || setup_.track.springs) {
            WheelRailEstimates own;
            solution = solve_in_balance(*this, estimates_ ? *estimates_ : own, observer);
        } else {
            solution = state_.Fz ? under_force(*state_.Fz, observer) : at(state_.position.height(), observer);
            place_profiles(solution);
            if (auto warning = off_tread_warning(solution, profiles_, position_.wheel(solution.z), position_.rail()))
                solution.warnings.push_back(std::move(*warning));
            if (!state_.Fz && !state_.derivatives && falls_where_regions_merge(solution, observer))
                solution.warnings.push_back(falling_force(solution.z));
        }
        if (state_.derivatives) {
            if (solution.rail_deflection)
                differentiate_on_flexible_rail(*this, solution, observer);
            else
                differentiate(*this, solution, observer);
            if (solution.derivatives && solution.derivatives->position.z.Fz < 0)
                solution.warnings.push_back(falling_force(solution.z));
        }
        for (WheelRailPatch& patch : solution.patches) add_fatigue(setup_, patch.place, patch.solution, observer);
        return solution;
    }
    solution.z = state_.position.height();
    solution.pitch_rate = state_.velocity.pitch;
    place_profiles(solution);
    solution.warnings.emplace_back(nothing_below);
    return solution;
}

WheelRailGeometry RightWheel::locate() {
    if (setup_.track.springs) {
        const WheelRailSetup setup = with_fixed_rail(setup_);
        const WheelRailState state = expected_on_flexible_rail(*this);
        return with(setup, state).locate();
    }
    WheelRailGeometry geometry;
    if (!first_contact_height()) {
        geometry.z = state_.position.height();
        place_profiles(geometry);
        geometry.warnings.emplace_back(nothing_below);
        return geometry;
    }
    geometry.z = expected_height();
    place_profiles(geometry);
    geometry.clearance = position_.clearance(geometry.z);
    check_depth(geometry.z);
    warn(geometry, warnings_of(position_.passed_over(geometry.z), setup_.side));
    for (const CandidatePatch& found : position_.candidates(geometry.z)) {
        geometry.places.push_back(found.place);
        warn(geometry, warnings_of(found, setup_, state_, false));
        const geometry::WheelSurface wheel = position_.wheel(geometry.z);
        warn(geometry, plausibility_warnings(found.place.reference, setup_.side, wheel, position_.rail()));
        warn(geometry, thin_data_warnings(found, setup_, state_, wheel, position_.rail()));
    }
    return geometry;
}

template <class Answer>
void RightWheel::place_profiles(Answer& answer) const {
    const geometry::WheelSurface wheel = position_.wheel(answer.z);
    answer.wheel_frame = profile_frame({wheel.profile_origin(), wheel.frame().axes});
    answer.rail_frame = profile_frame(position_.rail().frame());
}

std::size_t RightWheel::regions_at(double z) const {
    std::size_t regions = 0;
    for (const CandidatePatch& found : position_.candidates(z)) regions += found.place.regions.size();
    return regions;
}

bool RightWheel::falls_where_regions_merge(const WheelRailSolution& solution, Observer& observer) const {
    constexpr double step = 0.005, noise = 1e-3;  // step of the approach; noise of forces on other elements
    double approach = 0;
    for (const WheelRailPatch& patch : solution.patches)
        if (std::ranges::any_of(patch.place.shares, [](double share) { return share < 1; }))
            approach = std::max(approach, patch.place.approach);
    if (!(approach > 0)) return false;
    WheelRailSetup setup = setup_;
    setup.friction.reset();
    setup.temperature.reset();
    setup.wear.reset();
    setup.fatigue.reset();
    WheelRailState state = state_;
    state.motion = WheelRailMotion::steady_rolling;
    state.displacements = false;
    RightWheel above(setup, profiles_, influences_, state, observer_),
        below(setup, profiles_, influences_, state, observer_);
    const double more = below.at(solution.z + step * approach, observer).forces.track.Fz;
    return more < above.at(solution.z - step * approach, observer).forces.track.Fz * (1 - noise);
}

double RightWheel::expected_height() {
    return state_.Fz ? find_height(height_task(*state_.Fz)).z : state_.position.height();
}

bool RightWheel::bends() {
    if (!first_contact_height()) return false;
    if (setup_.track.springs) {
        const WheelRailSetup setup = with_fixed_rail(setup_);
        const WheelRailState state = expected_on_flexible_rail(*this);
        return with(setup, state).bends();
    }
    const double z = expected_height();
    check_depth(z);
    const auto candidates = position_.candidates(z);
    return std::any_of(candidates.begin(), candidates.end(),
                       [](const CandidatePatch& found) { return found.quality.bend > most_bend; });
}

std::optional<double> RightWheel::first_contact_height() const {
    const double clearance = position_.clearance(0);
    return std::isfinite(clearance) ? std::optional(clearance) : std::nullopt;
}

void RightWheel::check_depth(double z) const {
    const double clearance = position_.clearance(z);
    if (clearance < -deepest_penetration)
        throw InvalidArgument("state.position.z", "is " + number_text(z) + ", which is " + short_text(-clearance) +
                                                      " mm inside the rail; elastic contact allows at most " +
                                                      number_text(deepest_penetration) +
                                                      " mm: lift the wheelset, or prescribe Fz");
}

WheelRailSolution RightWheel::at(double z, Observer& observer) {
    check_depth(z);
    return at(z, position_.candidates(z), observer);
}

WheelRailSolution RightWheel::at(double z, std::vector<CandidatePatch> candidates, Observer& observer) {
    return solve(placed(z, std::move(candidates), observer), {.z = z}, observer);
}

Placement RightWheel::placed(double z, std::vector<CandidatePatch> candidates, Observer& observer) const {
    Placement placement{z, 0.05 * setup_.force.tolerance, setup_.accuracy};
    warn(placement, warnings_of(position_.passed_over(z), setup_.side));
    const TractionHistory history = history_of(candidates);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        CandidatePatch& found = candidates[i];
        observer.throw_if_cancelled();
        if (history.shares(i)) found.touches = found.place.grid;
        if (before_) position_.widen(found, history.widened(i), z);
        if (!position_.measure(found, z)) {
            placement.warnings.push_back(apart_along_normal(found.place.reference, setup_.side));
            continue;
        }
        ContactProblem problem = problem_of(found);
        problem.previous = history.on(i, problem);
        warn(placement, warnings_of(found, setup_, state_, setup_.friction && state_.motion != WheelRailMotion::shift));
        const geometry::WheelSurface wheel = position_.wheel(z);
        warn(placement, plausibility_warnings(found.place.reference, setup_.side, wheel, position_.rail()));
        warn(placement, thin_data_warnings(found, setup_, state_, wheel, position_.rail()));
        placement.add(std::move(found), std::move(problem));
    }
    if (history.force_left_behind() > 0 && !candidates.empty())
        placement.warnings.push_back("Tractions of the previous step, " + short_text(history.force_left_behind()) +
                                     " N, are farther from every contact than its own size and are neglected. Use "
                                     "shorter steps, or start anew.");
    return placement;
}

WheelRailSolution RightWheel::solve(const Placement& placement, const Load& load, Observer& observer) {
    WheelRailSolution solution;
    solution.pitch_rate = state_.velocity.pitch;
    solution.warnings = placement.warnings;
    solution.z = load.z;
    std::vector<WheelRailEstimates::Patch> estimates;
    for (const Placement::Patch& placed : placement.patches) {
        observer.throw_if_cancelled();
        ContactProblem problem = placed.problem;
        const bool carries = load.Fn && solution.patches.size() == load.patch;
        if (carries) {
            problem.approach.reset();
            problem.Fn = load.Fn;
        } else {
            problem.approach = placement.approach_at(load.z, placed);
        }
        solution.patches.push_back(solve(placed.found, std::move(problem), placed.kept(influences_), observer));
        WheelRailPatch& patch = solution.patches.back();
        if (carries && placement.is_single()) solution.z = placement.height_of(patch.solution.approach, placed);
        patch.forces = forces_of(patch, placed.found, solution.z);
        if (estimates_ && setup_.model == Model::full)
            estimates.push_back(estimate_of(placed.found, state_.position.x, patch.solution));
        solution.forces = sum(solution.forces, patch.forces);
        if (setup_.model == Model::full)
            solution.accuracy = std::max(solution.accuracy.value_or(0), accuracy_of(patch.solution.evidence));
        warn(solution, warnings_of(patch.place.reference, setup_.side, patch.solution));
    }
    if (solution.accuracy)
        solution.accuracy = std::max(*solution.accuracy, setup_.force.tolerance * placement.change_at(solution.z));
    constexpr double rounding = 1e-9;  // mm
    solution.clearance = position_.clearance(solution.z);
    if (solution.patches.empty() && std::abs(*solution.clearance) < rounding) solution.clearance = 0;
    if (estimates_) estimates_->patches = std::move(estimates);
    return solution;
}

TractionHistory RightWheel::history_of(const std::vector<CandidatePatch>& candidates) const {
    return {before_ ? *before_ : Patches{}, candidates, state_, setup_.patches.history};
}

ContactProblem RightWheel::problem_of(const CandidatePatch& found) const {
    return contactd::problem_of(setup_, state_, found, position_.rail());
}

ContactSolution RightWheel::solve(ContactProblem problem, const CandidatePatch& found, Observer& observer) const {
    return solve(std::move(problem), found, influences_, observer);
}

ContactSolution RightWheel::solve(ContactProblem problem, const CandidatePatch& found,
                                  const InfluenceSource& influences, Observer& observer) const {
    // The step of rolling is that of the set-up, or the distance rolled in the time of the state.
    const auto rename = [this](const std::string& field) {
        return field == "dq" && state_.time_step ? std::string("state.time_step") : field;
    };
    return renaming(rename, [&] {
        return solve_patch(std::move(problem), found.place, strips_of(setup_, profiles_, found), setup_.patches,
                           influences, observer);
    });
}

WheelRailPatch RightWheel::solve(const CandidatePatch& found, ContactProblem problem, const InfluenceSource& influences,
                                 Observer& observer) const {
    WheelRailPatch patch;
    problem.displacements = state_.displacements;
    if (has_tractions_) problem.initial = estimate_for(found.place, estimates_->patches);
    patch.solution = solve(std::move(problem), found, influences, observer);
    patch.place = found.place;
    if (has_distances(setup_)) patch.place.approach = patch.solution.approach;
    patch.gap = found.gap;
    return patch;
}

WheelRailForces RightWheel::forces_of(const WheelRailPatch& patch, const CandidatePatch& found, double z) const {
    return resultants(patch.place, patch.solution, !has_distances(setup_), {found.slopes, setup_.slope_forces},
                      position_.rail().frame(), position_.wheel(z).wheelset());
}

double RightWheel::simplified_force(double z, std::vector<CandidatePatch> candidates, Observer& observer) const {
    double force = 0;
    for (CandidatePatch& found : candidates) {
        // Forces of a whole ellipse need no elements; forces that are sums over elements need all of them.
        if (!rolls_on_elements(problem_of(found))) found.place.grid = Grid::of_elements(1, 1, setup_.dx, setup_.dy);
        force += forces_of(solve(found, problem_of(found), influences_, observer), found, z).track.Fz;
    }
    return force;
}

HeightTask RightWheel::height_task(double Fz) {
    const double compliance = setup_.bodies.materials().normal_compliance();
    HeightTask task;
    task.estimate = [this, compliance](double z) { return position_.expected_force(z, compliance); };
    task.force = task.estimate;
    task.first_contact_height = *first_contact_height();
    task.deepest = task.first_contact_height + deepest_penetration;
    task.target = Fz;
    task.settings = setup_.force;
    return task;
}

WheelRailSolution RightWheel::under_force(double Fz, Observer& observer) {
    const auto begin = std::chrono::steady_clock::now();
    // The first of many steps is bitwise equal to one without estimates.
    WheelRailEstimates own;
    const bool alone = estimates_ == nullptr;
    if (alone) estimates_ = &own;
    HeightTask task = height_task(Fz);
    task.correction = estimates_->height;
    task.correction.logarithm = estimates_->height_logarithm.expected().value_or(task.correction.logarithm);
    WheelRailSolution solution;
    const HeightFound found = has_distances(setup_) ? carry(Fz, task, solution, observer)
                                                    : carry_by_simplified_model(task, solution, observer);
    estimates_->height = found.correction;
    estimates_->height_logarithm.learn(found.correction.logarithm);
    if (alone) {
        estimates_ = nullptr;
        has_tractions_ = false;
    }
    solution.force = found.evidence;
    if (!found.evidence.converged) solution.warnings.push_back(missed_force(Fz, found));
    if (found.falls) solution.warnings.push_back(falling_force(found.z));
    const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
    solution.force->seconds = duration.count();
    return solution;
}

HeightFound RightWheel::carry_by_simplified_model(HeightTask& task, WheelRailSolution& solution, Observer& observer) {
    std::vector<CandidatePatch> candidates;  // at the last height
    task.force = [&](double& z) {
        check_depth(z);
        candidates = position_.candidates(z);
        return simplified_force(z, candidates, observer);
    };
    const HeightFound found = find_height(task);
    solution = at(found.z, std::move(candidates), observer);
    return found;
}

HeightFound RightWheel::carry(double Fz, HeightTask& task, WheelRailSolution& solution, Observer& observer) {
    constexpr int most_rounds = 5, most_lost = 2;
    constexpr double finer = 0.5;  // Answers from other starts then agree within the tolerance.
    std::optional<Placement> placement;
    std::optional<double> share = estimates_->vertical_share.expected();
    int solves = 0, lost = 0, most_solves = setup_.force.max_iterations;
    bool held = true;  // whether the last solve was at a height where its patches are unchanged
    const auto may_solve = [&] { return solves < most_solves; };
    const auto place = [&](double z) {
        if (placement && placement->holds_at(z)) return;
        check_depth(z);
        placement = placed(z, position_.candidates(z), observer);
    };
    const auto solve_for = [&](const Load& load) {
        ++solves;
        solution = solve(*placement, load, observer);
        has_tractions_ = true;
        share = placement->is_single() ? share_of(solution.patches.front()) : std::nullopt;
    };
    // The only patch of a wheel, if it has one region, carries the normal force that produces Fz in the last direction
    // of the whole force. Its approach determines the height, whose error is due to the friction's part of Fz. Contacts
    // of one or two elements may keep moving with the height; the height is then searched.
    const auto carries_alone = [&](double& z) {
        if (lost == most_lost) return false;
        double at = z;
        for (int round = 0; round < most_rounds && may_solve(); ++round) {
            if (position_.clearance(at) < -deepest_penetration) return false;
            place(at);
            if (!placement->is_single() || !share || *share < least_share) return false;
            solve_for({.z = at, .Fn = Fz / *share});
            at = solution.z;
            held = placement->holds_at(at);
            if (!held) continue;
            z = at;
            return true;
        }
        ++lost;
        return false;
    };
    task.force = [&](double& z) {
        if ((setup_.normal_model != NormalModel::of_model || !carries_alone(z)) && may_solve()) {
            place(z);
            solve_for({.z = z});
            held = true;
        }
        z = solution.z;
        return solution.forces.track.Fz;
    };
    // Forces jump where other elements or regions count: in penetration models by a hundredth if another element
    // becomes the deepest one. There, the largest patch carries the force in between, at one height.
    const auto carries_at_jump = [&](HeightFound& at) {
        constexpr double small_jump = 0.03;
        constexpr int few_rounds = 20;
        const bool is_small = setup_.normal_model != NormalModel::of_model && at.evidence.residual <= small_jump;
        if (!(at.jump || is_small) || solution.patches.empty()) return;
        const auto normal_force = [](const WheelRailPatch& patch) { return patch.solution.forces.Fn; };
        const auto index = static_cast<std::size_t>(std::ranges::max_element(solution.patches, {}, normal_force) -
                                                    solution.patches.begin());
        const auto kept = std::tuple(solution, estimates_->patches);
        for (int round = 0; round < few_rounds; ++round) {
            const WheelRailPatch& patch = solution.patches[index];
            const auto part = share_of(patch);
            if (!part || *part < least_share) break;
            const double Fn = patch.solution.forces.Fn + (Fz - solution.forces.track.Fz) / *part;
            if (!(Fn > 0)) break;
            solve_for({.z = at.z, .Fn = Fn, .patch = index});
            solution.z = at.z;
            const double residual = std::abs(solution.forces.track.Fz - Fz) / Fz;
            if (residual > task.settings.tolerance) continue;
            at.evidence.residual = residual;
            if (at.jump && !is_small) solution.warnings.push_back(jumping_force(at));
            return;
        }
        std::tie(solution, estimates_->patches) = kept;
    };
    task.settings.tolerance *= finer;
    HeightFound found = find_height(task);
    if (!found.evidence.converged) carries_at_jump(found);
    // If the previous step had other regions, and its branch of the force still produces Fz at a nearby height, this
    // step stays on that branch.
    const auto stay_on_branch = [&] {
        constexpr double farthest_branch = 0.3;  // of the depth
        const std::size_t before = estimates_->regions, here = regions_in(solution);
        if (before == 0 || here == 0 || here == before) return;
        const double reach = farthest_branch * (found.z - task.first_contact_height);
        const bool above = here < before;
        const auto border = nearest_height(
            [&](double z) {
                const std::size_t regions = regions_at(z);
                return above ? regions > here && regions <= before : regions < here && regions >= before;
            },
            found.z, found.z + (above ? -reach : reach));
        if (!border) return;
        most_solves = solves + setup_.force.max_iterations;
        const auto kept = std::tuple(solution, found, held, estimates_->patches);
        place(*border);
        solve_for({.z = *border});
        HeightTask branch = task;
        if (above)
            branch.deepest = *border;
        else
            branch.shallowest = *border;
        branch.correction = {estimates_->height_logarithm.expected().value_or(0), 0};
        if ((solution.forces.track.Fz >= Fz) == above) {
            const HeightFound other = find_height(branch);
            if (other.evidence.converged && held && regions_in(solution) != here) {
                found = other;
                found.falls = true;
                return;
            }
        }
        std::tie(solution, found, held, estimates_->patches) = kept;
    };
    stay_on_branch();
    estimates_->regions = regions_in(solution);
    found.evidence.iterations = solves;
    found.evidence.converged = held && found.evidence.residual <= setup_.force.tolerance;
    estimates_->vertical_share.learn(share);
    return found;
}

}  // namespace contactd
