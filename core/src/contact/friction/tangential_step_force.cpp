// Solves steps whose motion is computed from prescribed forces.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tangential_step.hpp"

namespace contactd {
namespace {

Motion with_translation(Motion motion, const Pair& translation) {
    if (auto* rolling = std::get_if<Rolling>(&motion)) {
        rolling->xi = translation.x();
        rolling->eta = translation.y();
    } else {
        auto& shift = std::get<Shift>(motion);
        shift.rigid_shift.x = translation.x();
        shift.rigid_shift.y = translation.y();
    }
    return motion;
}

/// Returns the mean slip weighted with the bound: the slip that tractions near the bound resist.
Pair mean_slip(const Field& slip, std::span<const double> bound) {
    Pair sum = Pair::Zero();
    double weight = 0;
    for (std::size_t i = 0; i < bound.size(); ++i) {
        sum += bound[i] * Pair(slip.x[i], slip.y[i]);
        weight += bound[i];
    }
    return weight > 0 ? Pair(sum / weight) : sum;
}

/// Returns the initial rigid slip of the components with prescribed forces. If there are initial tractions, the motion
/// of the request belongs to them.
Pair first_rigid_slip(const PrescribedForces& forces, const Field& rest, std::span<const double> bound,
                      const Field& estimate) {
    const auto of_forces = [&](const Pair& all) { return Pair(forces.Fx ? all.x() : 0, forces.Fy ? all.y() : 0); };
    const Pair asked = of_forces({forces.wx, forces.wy});
    if (any(estimate) && asked != Pair::Zero()) return asked;
    return expected_rigid_slip(forces) - of_forces(mean_slip(rest, bound));
}

}  // namespace

void TangentialStep::expect(const Motion& motion) {
    estimate_is_good_ = true;
    const auto* rolls = std::get_if<Rolling>(&motion);
    const auto* shifts = std::get_if<Shift>(&motion);
    motion_ = with_translation(
        motion_, rolls ? Pair(rolls->xi, rolls->eta) : Pair(shifts->rigid_shift.x, shifts->rigid_shift.y));
}

RollingSolution TangentialStep::solve_for_force(const Field& rest, std::span<const double> bound, const Field& estimate,
                                                const SolverSettings& settings, Observer& observer) {
    PrescribedForces forces = prescribed_forces(bound);
    const double missing = is_first_ ? 0 : reduce_to_bound(forces);
    require_reachable(forces, problem_.settings.outer);
    const FrictionSolution at_once = asks_tang_cg() || !entering_.empty()
                                         ? FrictionSolution{}
                                         : solve_at_once(forces, rest, bound, estimate, settings, observer);
    RollingSolution solution = at_once;
    if (!at_once.evidence.converged) {
        solution = search(forces, rest, bound, estimate, observer);
        solution.evidence.iterations += at_once.evidence.iterations;
        solution.evidence.seconds += at_once.evidence.seconds;
    }
    if (missing > 0) {
        force_evidence_->converged = false;
        force_evidence_->residual = missing;
    }
    return solution;
}

// Leaves the motion unchanged if the solve does not converge.
FrictionSolution TangentialStep::solve_at_once(const PrescribedForces& forces, const Field& rest,
                                               std::span<const double> bound, const Field& estimate,
                                               const SolverSettings& settings, Observer& observer) {
    FrictionSolution solution;
    if (!(forces.largest > 0)) return solution;
    const Pair known(forces.Fx ? 0 : forces.wx, forces.Fy ? 0 : forces.wy);
    const Motion asked = std::exchange(motion_, with_translation(motion_, known / unit_));
    Field rigid = rigid_slip();
    add(rigid, rest);
    const Pair start = is_first_ ? first_rigid_slip(forces, rest, bound, estimate) : Pair(forces.wx, forces.wy) - known;
    const bool is_loose = settings.tolerance > problem_.settings.tangential.tolerance;
    const double tolerance = problem_.settings.outer.tolerance;
    const ForcesGiven given{{forces.Fx.has_value(), forces.Fy.has_value()},
                            Pair(forces.Fx.value_or(0), forces.Fy.value_or(0)) / problem_.grid.element_area(),
                            is_loose ? std::max(tolerance, settings.tolerance) : tolerance};
    solution = solver_.solve({bound, rigid, given, start, estimate, settings, estimate_is_good_, flow_}, observer);
    motion_ = asked;
    if (!solution.evidence.converged) return solution;
    motion_ = with_translation(motion_, (known + solution.uniform) / unit_);
    continue_force_evidence(solution.evidence);
    force_evidence_->residual = solution.force_residual;
    return solution;
}

// Forces are met to the problem's tolerance even in loose outer iterations, because near the bound, inaccurate forces
// do not determine the motion.
RollingSolution TangentialStep::search(const PrescribedForces& forces, const Field& rest, std::span<const double> bound,
                                       const Field& estimate, Observer& observer) {
    RollingSolution solution;
    SolverEvidence all;  // evidence of the tangential solves together
    const Field* start = &estimate;
    Field last;
    const auto solve = [&](double wx, double wy, double tolerance) -> ForcesAtSlip {
        motion_ = with_translation(motion_, Pair(wx, wy) / unit_);
        Field rigid = rigid_slip();
        add(rigid, rest);
        SilentObserver silent(observer);
        SolverSettings one = problem_.settings.tangential;
        if (tolerance > problem_.settings.outer.tolerance) one.tolerance = std::max(one.tolerance, tolerance);
        solution = solve_with({bound, rigid, {}, Pair::Zero(), *start, one, start == &last, flow_}, silent);
        last.x = solution.traction_x;
        last.y = solution.traction_y;
        start = &last;
        all.iterations += solution.evidence.iterations;
        all.seconds += solution.evidence.seconds;
        const TangentialForces reached = tangential_forces(problem_.grid, last.x, last.y);
        return {reached.Fx, reached.Fy, solution.evidence.converged};
    };
    const RigidSlipForForces found = find_rigid_slip(forces, search_settings(), solve, observer);
    motion_ = with_translation(motion_, Pair(found.wx, found.wy) / unit_);
    continue_force_evidence(found.evidence);
    solution.evidence.iterations = all.iterations;
    solution.evidence.seconds = all.seconds;
    return solution;
}

// If outer iterations contain the search, their limit does not apply to the search within each of them.
SolverSettings TangentialStep::search_settings() const {
    SolverSettings settings = problem_.settings.outer;
    const bool is_within =
        influence_.current->coupled() || problem_.friction->kinetic || problem_.friction->follows_temperature();
    if (is_within) settings.max_iterations = std::max(settings.max_iterations, ContactSettings{}.outer.max_iterations);
    return settings;
}

// The evidence covers all solves of a step; the last one determines its state.
void TangentialStep::continue_force_evidence(const SolverEvidence& next) {
    SolverEvidence all = is_first_ ? SolverEvidence{} : force_evidence_.value_or(SolverEvidence{});
    force_evidence_ = {all.iterations + next.iterations, next.residual, next.converged, all.seconds + next.seconds};
}

PrescribedForces TangentialStep::prescribed_forces(std::span<const double> bound) {
    PrescribedForces forces;
    const double area = problem_.grid.element_area();
    const auto in_contact = std::count_if(bound.begin(), bound.end(), [](double g) { return g > 0; });
    for (const double g : bound) forces.largest += g * area;
    if (is_first_) slip_scale_ = slip_scale(*influence_.current, bound);
    forces.scale = slip_scale_;
    if (const Rolling* given = rolling()) {
        forces.Fx = given->force.Fx;
        forces.Fy = given->force.Fy;
        forces.wx = unit_ * given->xi;
        forces.wy = unit_ * given->eta;
        forces.field = "friction.rolling.force";
        if (given->steady()) {
            // On the way through the contact, of which a step is a part, particles slip by this amount.
            const double radius = std::sqrt(static_cast<double>(in_contact) * area / std::numbers::pi);
            if (radius > 0) forces.scale *= std::min(unit_ / radius, 1.0);
            forces.exponent = PrescribedForces::rolling_exponent;
        }
        return forces;
    }
    const auto& shift = std::get<Shift>(motion_);
    forces.Fx = shift.force.Fx;
    forces.Fy = shift.force.Fy;
    forces.wx = shift.rigid_shift.x;
    forces.wy = shift.rigid_shift.y;
    return forces;
}

// A force beyond the first bound of a step is refused. Later bounds belong to an iterate, which must not cause an
// error: if friction or the pressure has decreased below the force, the force is reduced to what they carry until they
// increase again. Returns the missing part over the bound.
double TangentialStep::reduce_to_bound(PrescribedForces& forces) const {
    constexpr double carried = 0.99;  // The full bound would need an infinite slip.
    const double force = std::hypot(forces.Fx.value_or(0), forces.Fy.value_or(0));
    if (force == 0 || force < largest_force_with_a_slip(forces.largest, problem_.settings.outer)) return 0;
    const double part = carried * forces.largest / force;
    for (std::optional<double>* component : {&forces.Fx, &forces.Fy})
        if (*component) **component *= part;
    return forces.largest > 0 ? force / forces.largest - carried : 1;
}

}  // namespace contactd
