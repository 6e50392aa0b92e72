#include "tangential_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/tangential/slip.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

void add(Field& to, const Field& from, double factor = 1) {
    for (std::size_t i = 0; i < to.x.size(); ++i) {
        to.x[i] += factor * from.x[i];
        to.y[i] += factor * from.y[i];
    }
}

bool any(const Field& field) {
    return inner(field, field) > 0;
}

bool prescribes_force(const Motion& motion) {
    return std::visit([](const auto& m) { return !m.force.empty(); }, motion);
}

void set_translation(Motion& motion, double x, double y) {
    if (auto* rolling = std::get_if<Rolling>(&motion)) {
        rolling->xi = x;
        rolling->eta = y;
    } else {
        std::get<Shift>(motion).rigid_shift = {x, y};
    }
}

}  // namespace

TangentialStep::TangentialStep(const ContactProblem& problem, const ContactInfluence& influence)
    : problem_(problem), influence_(influence), n_(problem.grid.size()), motion_(problem.motion) {
    if (rolling()) unit_ = step_length(*rolling(), problem.grid);
}

// Slip of the motion itself, w of a shift, dq w of rolling, and what the elements have beside it.
Field TangentialStep::rigid_slip() const {
    const Grid& grid = problem_.grid;
    RigidSlip slip = rolling() ? contactd::rigid_slip(grid, *rolling(), unit_)
                               : contactd::rigid_slip(grid, std::get<Shift>(motion_));
    Field result;
    result.x = std::move(slip.x);
    result.y = std::move(slip.y);
    const RigidSlip& beside = problem_.rigid_slip;
    for (std::size_t i = 0; i < beside.x.size(); ++i) {
        result.x[i] += unit_ * beside.x[i];
        result.y[i] += unit_ * beside.y[i];
    }
    return result;
}

RollingBodies TangentialStep::bodies() const {
    const auto [x, y] = step_of(problem_);
    return {*influence_.here, *influence_.change, problem_.grid, x, y};
}

// Particles had the displacements A' p_before of where they were, and A' = A - C; of a shift C is zero. A steady state
// knows no step before.
void TangentialStep::begin(const Tractions& before) {
    before_ = before;
    is_first_ = true;
    history_ = Field(n_);
    if (rolling() && rolling()->steady()) return;
    Field u(n_);
    const auto add_product = [&](const auto& influence, double factor) {
        if (any(before.tangential)) {
            influence.tangential(before.tangential.x, before.tangential.y, u.x, u.y);
            add(history_, u, factor);
        }
        if (!influence.coupled()) return;
        influence.tangential_of_normal(before.pressure, u.x, u.y);
        add(history_, u, factor);
    };
    add_product(*influence_.here, -1);
    if (rolling()) add_product(*influence_.change, 1);
}

void TangentialStep::add_coupling(std::span<const double> pressure, Field& rigid) const {
    const auto add_product = [&](const auto& influence) {
        if (!influence.coupled()) return;
        Field u(n_);
        influence.tangential_of_normal(pressure, u.x, u.y);
        add(rigid, u);
    };
    if (rolling() && rolling()->steady())
        add_product(*influence_.change);
    else
        add_product(*influence_.here);
}

RollingSolution TangentialStep::solve(std::span<const double> pressure, std::span<const double> bound,
                                      const Field& estimate, Observer& observer) {
    Field rest = history_;
    add_coupling(pressure, rest);
    RollingSolution solution;
    if (prescribes_force(motion_)) {
        solution = solve_for_force(rest, bound, estimate, observer);
    } else {
        Field rigid = rigid_slip();
        add(rigid, rest);
        solution = solve_with(rigid, bound, estimate, problem_.settings.tangential, observer);
    }
    add_free_slip(pressure, bound, rest, solution);
    return solution;
}

// The solvers know the elements that friction may hold; where there is contact without friction the surfaces slip too.
void TangentialStep::add_free_slip(std::span<const double> pressure, std::span<const double> bound, const Field& rest,
                                   RollingSolution& solution) const {
    const auto is_free = [&](std::size_t i) { return pressure[i] > 0 && !(bound[i] > 0); };
    std::size_t first = 0;
    while (first < n_ && !is_free(first)) ++first;
    if (first == n_) return;
    Field slip = rigid_slip(), u(n_);
    add(slip, rest);
    if (rolling() && rolling()->steady())
        influence_.change->tangential(solution.traction_x, solution.traction_y, u.x, u.y);
    else
        influence_.here->tangential(solution.traction_x, solution.traction_y, u.x, u.y);
    for (std::size_t i = first; i < n_; ++i) {
        if (!is_free(i)) continue;
        solution.slip_x[i] = slip.x[i] + u.x[i];
        solution.slip_y[i] = slip.y[i] + u.y[i];
        solution.element_division[i] = ElementState::slip;
    }
}

RollingSolution TangentialStep::solve_for_force(const Field& rest, std::span<const double> bound, const Field& estimate,
                                                Observer& observer) {
    RollingSolution solution;
    SolverEvidence all;  // of the tangential solves together
    const Field* start = &estimate;
    Field last;
    const auto solve = [&](double wx, double wy, double tolerance) -> ForcesAtSlip {
        set_translation(motion_, wx / unit_, wy / unit_);
        Field rigid = rigid_slip();
        add(rigid, rest);
        SilentObserver silent(observer);
        SolverSettings settings = problem_.settings.tangential;
        if (tolerance > problem_.settings.outer.tolerance) settings.tolerance = std::max(settings.tolerance, tolerance);
        solution = solve_with(rigid, bound, *start, settings, silent);
        last.x = solution.traction_x;
        last.y = solution.traction_y;
        start = &last;
        all.iterations += solution.evidence.iterations;
        all.seconds += solution.evidence.seconds;
        const TangentialForces forces = tangential_forces(problem_.grid, last.x, last.y);
        return {forces.Fx, forces.Fy, solution.evidence.converged};
    };
    PrescribedForces forces = prescribed_forces(bound);
    const double missing = is_first_ ? 0 : reduce_to_bound(forces);
    is_first_ = false;
    const RigidSlipForForces found = find_rigid_slip(forces, problem_.settings.outer, solve, observer);
    set_translation(motion_, found.wx / unit_, found.wy / unit_);
    force_evidence_ = found.evidence;
    if (missing > 0) {
        force_evidence_->converged = false;
        force_evidence_->residual = missing;
    }
    solution.evidence.iterations = all.iterations;
    solution.evidence.seconds = all.seconds;
    return solution;
}

PrescribedForces TangentialStep::prescribed_forces(std::span<const double> bound) const {
    PrescribedForces forces;
    const double area = problem_.grid.element_area();
    const auto in_contact = std::count_if(bound.begin(), bound.end(), [](double g) { return g > 0; });
    for (const double g : bound) forces.largest += g * area;
    forces.scale = slip_scale(*influence_.here, bound);
    if (const Rolling* given = rolling()) {
        forces.Fx = given->force.Fx;
        forces.Fy = given->force.Fy;
        forces.wx = unit_ * given->xi;
        forces.wy = unit_ * given->eta;
        forces.field = "friction.rolling.force";
        if (given->steady()) {
            // Particles slip that far on their way through the contact, of which a step is a part.
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

// A force beyond the first bound of a step is refused. Later ones belong to an iterate, of which nobody should hear:
// where friction has fallen below the force, or the pressure has, the force is what they carry until they rise again.
// Returns what is missing, over the bound.
double TangentialStep::reduce_to_bound(PrescribedForces& forces) const {
    constexpr double carried = 0.99;  // all of it needs an infinite slip
    const double force = std::hypot(forces.Fx.value_or(0), forces.Fy.value_or(0));
    if (force == 0 || force < largest_force_with_a_slip(forces.largest, problem_.settings.outer)) return 0;
    const double part = carried * forces.largest / force;
    for (std::optional<double>* component : {&forces.Fx, &forces.Fy})
        if (*component) **component *= part;
    return forces.largest > 0 ? force / forces.largest - carried : 1;
}

RollingSolution TangentialStep::solve_with(const Field& rigid, std::span<const double> bound, const Field& estimate,
                                           const SolverSettings& settings, Observer& observer) const {
    std::span<const double> x, y;
    if (any(estimate)) {
        x = estimate.x;
        y = estimate.y;
    }
    if (rolling() && rolling()->steady())
        return solve_steady_rolling(bodies(), bound, rigid.x, rigid.y, settings, x, y, observer);
    RollingSolution solution;
    static_cast<TangentialSolution&>(solution) =
        solve_tangential(*influence_.here, bound, rigid.x, rigid.y, settings, x, y, observer);
    SlipDistance slip =
        slip_distance(*influence_.here, bound, rigid.x, rigid.y, solution.traction_x, solution.traction_y);
    solution.slip_x = std::move(slip.x);
    solution.slip_y = std::move(slip.y);
    return solution;
}

}  // namespace contactd
