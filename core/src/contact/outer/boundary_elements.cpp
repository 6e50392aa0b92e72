#include "boundary_elements.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "closed_forms/undeformed_distance.hpp"
#include "coarse_outer_iterations.hpp"
#include "contact/derivatives/differentiate.hpp"
#include "contact/friction/curved_strips.hpp"
#include "contact/friction/layer_flow.hpp"
#include "contact/friction/tangential_step.hpp"
#include "contact/friction/temperature_law.hpp"
#include "contact/friction/tractions.hpp"
#include "contact/normal/approach_operator.hpp"
#include "contact/normal/hertz_start.hpp"
#include "contact/normal/normal_solver.hpp"
#include "contact/penetration/virtual_penetration.hpp"
#include "contact/support/solver_support.hpp"
#include "contact/tangential/friction_law.hpp"
#include "contact/tangential/friction_memory.hpp"
#include "outer_tolerances.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

// Smaller coefficients count as zero, because squares of such tractions underflow.
constexpr double least_friction = 1e-100;

/// Adds iterations and times of successive solves; the last one determines the state.
void continue_with(SolverEvidence& evidence, const SolverEvidence& next) {
    evidence = {evidence.iterations + next.iterations, next.residual, next.converged, evidence.seconds + next.seconds};
}

bool changes_with_temperature(const FrictionLaw& friction) {
    const auto changes = [](const TemperatureFriction& law) { return law.change != 0; };
    return (friction.temperature && changes(*friction.temperature)) ||
           std::ranges::any_of(friction.temperature_of_rows, changes);
}

class BoundaryElements {
   public:
    BoundaryElements(const ContactProblem& problem, const ContactInfluence& influence)
        : problem_(problem),
          influences_(influence),
          influence_(*influence.current),
          n_(problem.grid.size()),
          distance_(undeformed_distance(problem)),
          now_(first_estimate(problem)),
          along_approach_(along_approach_of(problem, influence_)),
          normal_(along_approach_ ? *along_approach_ : influence_) {
        if (!problem.friction) return;
        const FrictionLaw& friction = *problem.friction;
        step_.emplace(problem, influence);
        if (friction.layer && friction.layer->yields()) layer_.emplace(problem);
        static_mu_.resize(n_);
        for (std::size_t i = 0; i < n_; ++i) static_mu_[i] = friction.mu_of(i);
        bound_ = bound_of(static_mu_);
        if (changes_with_temperature(friction)) temperature_law_.emplace(problem);
        if (!friction.kinetic) return;
        slip_law_.emplace(*friction.kinetic, static_mu_);
        if (!friction.kinetic->memory) return;
        memory_.emplace(problem, static_mu_);
        slip_law_->carry(*memory_);
    }

    ContactSolution solve(Observer& observer) {
        const int steps = number_of_steps();
        Tractions before =
            make_tractions(n_, problem_.previous.pressure, problem_.previous.traction_x, problem_.previous.traction_y);
        const SurfaceState* particles = &problem_.previous;
        Field last;  // tractions of the previous step but one
        for (int step = 0; step < steps; ++step) {
            PartObserver part(observer, static_cast<double>(step) / steps, (step + 1.0) / steps);
            if (step_) step_->begin(before);
            if (layer_) layer_->begin(particles->yield_stress);
            if (memory_) memory_->begin(particles->friction_coefficient);
            if (step >= 2) go_on(before.tangential, last);
            take_step(part, step == 0);
            remember_failures();
            last = std::move(before.tangential);
            before = now_;
            particles = &particles_;
        }
        return finished();
    }

   private:
    // The motion is the same in all steps, so they start from an extrapolation of the last two.
    void go_on(const Field& before, const Field& last) {
        for (std::size_t i = 0; i < n_; ++i) {
            now_.tangential.x[i] += before.x[i] - last.x[i];
            now_.tangential.y[i] += before.y[i] - last.y[i];
        }
    }

    int number_of_steps() const {
        if (!problem_.friction) return 1;
        const auto* rolling = std::get_if<Rolling>(&problem_.motion);
        return rolling && !rolling->steady() ? rolling->steps : 1;
    }

    // A step that has not converged makes all following steps wrong, however well these converge.
    void remember_failures() {
        const auto keep = [](const std::optional<SolverEvidence>& now, std::optional<SolverEvidence>& failed) {
            if (now && !now->converged && !(failed && failed->residual > now->residual)) failed = now;
        };
        keep(solution_.evidence.normal, failed_.normal);
        keep(solution_.evidence.tangential, failed_.tangential);
        keep(solution_.evidence.outer, failed_.outer);
        if (step_) keep(step_->force_evidence(), failed_.force);
    }

    // Applies Panagiotopoulos' process if the bodies are coupled, and successive coefficients if friction depends on
    // slip or heat.
    void take_step(Observer& observer, bool first) {
        const bool coupled = step_ && influence_.coupled();
        const bool repeats = coupled || slip_law_ || temperature_law_;
        if (repeats) solution_.evidence.outer = SolverEvidence{};
        const Stopwatch stopwatch;
        OuterTolerances tolerances(problem_, coupled && !slip_law_ && !temperature_law_);
        for (int iteration = 1;; ++iteration) {
            const Tractions last = now_;
            const bool solved_finally = tolerances.are_final();
            IterationObserver part(observer, iteration, repeats ? 0.3 : 1);
            if ((first && iteration == 1) || coupled) solve_normal_contact(tolerances, part);
            if (!step_) return;
            if (!(first && iteration == 1 && coupled && !solved_finally && start_on_coarser(part)))
                solve_tangential_contact(tolerances.tangential(), part);
            if (!repeats) return;
            const double friction_change = follow_friction();
            tolerances.follow(std::max(relative_change(now_, last), friction_change));
            // The next solve would be the same.
            const bool is_settled = temperature_law_ && !coupled && friction_change == 0;
            const double left = is_settled ? 0 : tolerances.left();
            const bool converged = left <= problem_.settings.outer.tolerance && solved_finally;
            solution_.evidence.outer = {iteration, left, converged, stopwatch.seconds()};
            if (converged || iteration == problem_.settings.outer.max_iterations) return;
        }
    }

    /// Computes pressures by virtual penetration, which do not depend on the tractions.
    void take_penetration() {
        if (influence_.coupled())
            throw InvalidArgument("normal_model",
                                  "is given, but the bodies are dissimilar. Their pressures depend on the tractions, "
                                  "which normal_model does not support: use similar bodies, or remove it");
        PenetrationContact found = penetration_contact(problem_, distance_);
        now_.pressure = std::move(found.pressure);
        solution_.approach = found.approach;
        solution_.evidence.normal = found.evidence;
        solution_.warnings = std::move(found.warnings);
    }

    void solve_normal_contact(const OuterTolerances& tolerances, Observer& observer) {
        if (problem_.normal_model != NormalModel::of_model) return take_penetration();
        Values gap = distance_;
        if (step_ && influence_.coupled() && inner(now_.tangential, now_.tangential) > 0) {
            Values uz(n_);
            influence_.normal_of_tangential(now_.tangential.x, now_.tangential.y, uz);
            for (std::size_t i = 0; i < n_; ++i) gap[i] += uz[i];
        }
        PartObserver part(observer, 0, step_ ? 0.3 : 1);
        NormalSolution normal = solve_under_load(gap, tolerances, part);
        now_.pressure = std::move(normal.pressure);
        continue_with(solution_.evidence.normal, normal.evidence);
    }

    static std::unique_ptr<const ApproachOperator> along_approach_of(const ContactProblem& problem,
                                                                     const InfluenceOperator& influence) {
        if (!problem.columns) return nullptr;
        return std::make_unique<const ApproachOperator>(influence, facing(*problem.columns, problem.grid));
    }

    NormalSolution solve_under_load(Values& gap, const OuterTolerances& tolerances, Observer& observer) {
        if (!along_approach_) return solve_along_approach(gap, now_.pressure, tolerances, observer);
        gap = along_approach_->over_cosine(std::move(gap));
        const Values estimate = along_approach_->times_cosine(now_.pressure);
        NormalSolution normal = solve_along_approach(gap, estimate, tolerances, observer);
        normal.pressure = along_approach_->over_cosine(std::move(normal.pressure));
        return normal;
    }

    NormalSolution solve_along_approach(Values& gap, const Values& estimate, const OuterTolerances& tolerances,
                                        Observer& observer) {
        // Pressures that miss a part of the contact may not carry a prescribed force.
        NormalTask task{gap, {}, tolerances.normal(), !tolerances.are_final() && !prescribes_force(problem_.motion)};
        if (problem_.Fn) {
            task.pressure_sum = *problem_.Fn / problem_.grid.element_area();
        } else {
            for (double& h : gap) h -= *problem_.approach;
        }
        NormalSolution normal = has_pressures_
                                    ? normal_.solve_again(task, estimate, observer)
                                    : normal_.solve(task, estimate, [this] { return hertz_start(problem_); }, observer);
        has_pressures_ = true;
        solution_.approach = problem_.Fn ? normal.approach : *problem_.approach;
        return normal;
    }

    void solve_tangential_contact(const SolverSettings& settings, Observer& observer) {
        Values bound = bound_of(followed_mu());
        keep_at_bound(bound);
        bound_ = std::move(bound);
        PartObserver part(observer, 0.3, 1);
        tangential_ =
            step_->solve(now_.pressure, bound_, now_.tangential, settings, layer_ ? layer_->task() : nullptr, part);
        now_.tangential.x = tangential_.traction_x;
        now_.tangential.y = tangential_.traction_y;
        if (layer_) {
            layer_->divide(bound_of_friction(followed_mu()), tangential_);
            particles_.yield_stress = tangential_.yield_stress;
        }
        auto& evidence = solution_.evidence.tangential;
        if (!evidence) evidence = SolverEvidence{};
        continue_with(*evidence, tangential_.evidence);
        solution_.evidence.tangential_solver = step_->solver_used();
    }

    // Replaces the first outer iteration by iterations on the coarser grid.
    bool start_on_coarser(const Observer& observer) {
        if (any(now_.tangential) || problem_.settings.outer.max_iterations == 1) return false;
        bound_ = bound_of(static_mu_);
        auto start = outer_iterations_on_coarser(problem_, influences_, distance_, bound_, observer);
        if (!start) return false;
        now_.tangential = std::move(start->tractions);
        step_->expect(start->motion);
        return true;
    }

    Values bound_of_friction(const Values& mu) const {
        Values bound = now_.pressure;
        for (std::size_t i = 0; i < n_; ++i) bound[i] *= mu[i] >= least_friction ? mu[i] : 0;
        return bound;
    }

    Values bound_of(const Values& mu) const {
        Values bound = bound_of_friction(mu);
        if (layer_) layer_->limit(bound);
        return bound;
    }

    // Keeps tractions at their bound if they were there, so that the estimate shows where there was slip.
    void keep_at_bound(const Values& bound) {
        constexpr double on_bound = 1e-9;
        if (bound == bound_) return;
        auto& [x, y] = now_.tangential;
        for (std::size_t i = 0; i < n_; ++i) {
            if (!(bound_[i] > 0)) continue;
            const double size = std::sqrt(x[i] * x[i] + y[i] * y[i]);
            if (!(size >= bound_[i] * (1 - on_bound))) continue;
            x[i] *= bound[i] / size;
            y[i] *= bound[i] / size;
        }
    }

    /// Updates the coefficients of friction to the slip or its heat, and returns their distance from the new ones.
    double follow_friction() {
        if (!slip_law_ && !temperature_law_) return 0;
        const auto* rolling = std::get_if<Rolling>(&problem_.motion);
        const double seconds = rolling ? step_->unit() / rolling->velocity : std::get<Shift>(problem_.motion).duration;
        Values velocity(n_);
        for (std::size_t i = 0; i < n_; ++i)
            if (tangential_.element_division[i] > ElementState::adhesion)
                velocity[i] = std::hypot(tangential_.slip_x[i], tangential_.slip_y[i]) / seconds;
        if (temperature_law_) {
            const double change = temperature_law_->follow(motion_of_elements(std::move(velocity)), now_.pressure);
            if (temperature_law_->has_memory()) particles_.friction_coefficient = temperature_law_->mu();
            return change;
        }
        const double change = slip_law_->follow(velocity, now_.pressure);
        particles_.friction_coefficient = slip_law_->mu();
        return change;
    }

    MotionOfElements motion_of_elements(Values slip_velocity) const {
        const double unit = step_->unit(), velocity = std::get<Rolling>(problem_.motion).velocity;
        MotionOfElements motion{std::move(slip_velocity),
                                {},
                                mean_slip_of_rows(static_cast<std::size_t>(problem_.grid.nx), now_.pressure,
                                                  tangential_.slip_x, tangential_.flow_x)};
        for (double& slip : motion.slip_of_rows) slip /= unit;
        for (std::size_t i = 0; i < tangential_.flow_x.size(); ++i) {
            const double work =
                tangential_.traction_x[i] * tangential_.flow_x[i] + tangential_.traction_y[i] * tangential_.flow_y[i];
            motion.plastic_heat.push_back(problem_.temperature->plastic_share * std::max(0.0, work) * velocity / unit);
        }
        return motion;
    }

    const Values& followed_mu() const {
        if (temperature_law_) return temperature_law_->mu();
        return slip_law_ ? slip_law_->mu() : static_mu_;
    }

    ContactSolution finished() {
        solution_.pressure = std::move(now_.pressure);
        solution_.element_division.assign(n_, ElementState::exterior);
        for (std::size_t i = 0; i < n_; ++i)
            // Without friction all elements slip.
            if (solution_.pressure[i] > 0) solution_.element_division[i] = ElementState::slip;
        solution_.traction_x.resize(n_);
        solution_.traction_y.resize(n_);
        if (step_) take_tangential_solution();
        report_failures();
        return std::move(solution_);
    }

    void report_failures() {
        const auto report = [](SolverEvidence& evidence, const std::optional<SolverEvidence>& failed) {
            if (!failed) return;
            evidence.converged = false;
            evidence.residual = failed->residual;
        };
        report(solution_.evidence.normal, failed_.normal);
        if (solution_.evidence.tangential) report(*solution_.evidence.tangential, failed_.tangential);
        if (solution_.evidence.outer) report(*solution_.evidence.outer, failed_.outer);
        if (solution_.evidence.force) report(*solution_.evidence.force, failed_.force);
    }

    void take_tangential_solution() {
        for (std::size_t i = 0; i < n_; ++i)
            if (tangential_.element_division[i] != ElementState::exterior)
                solution_.element_division[i] = tangential_.element_division[i];
        solution_.traction_x = std::move(tangential_.traction_x);
        solution_.traction_y = std::move(tangential_.traction_y);
        solution_.slip_x = std::move(tangential_.slip_x);
        solution_.slip_y = std::move(tangential_.slip_y);
        solution_.flow_x = std::move(tangential_.flow_x);
        solution_.flow_y = std::move(tangential_.flow_y);
        if (layer_ && layer_->task() != nullptr) solution_.yield_stress = std::move(tangential_.yield_stress);
        solution_.friction_coefficient = std::move(particles_.friction_coefficient);
        solution_.motion = step_->motion();
        solution_.evidence.force = step_->force_evidence();
    }

    const ContactProblem& problem_;
    const ContactInfluence& influences_;
    const InfluenceOperator& influence_;
    const std::size_t n_;
    const Values distance_;
    std::optional<TangentialStep> step_;
    std::optional<LayerFlow> layer_;  // of a layer that yields
    Tractions now_;
    SurfaceState particles_;  // besides tractions, at the end of the last step, as far as the friction law keeps it
    const std::unique_ptr<const ApproachOperator> along_approach_;  // for curved strips only
    NormalSolver normal_;
    // It is set if there are pressures of an earlier solve, which are nearer than a closed form.
    bool has_pressures_ = false;
    Values static_mu_;  // per element
    Values bound_;      // of the present tractions
    std::optional<CarriedFriction> memory_;
    std::optional<SlipLawIteration> slip_law_;
    std::optional<TemperatureLaw> temperature_law_;
    RollingSolution tangential_;
    struct {
        std::optional<SolverEvidence> normal, tangential, outer, force;
    } failed_;  // worst of all steps
    ContactSolution solution_;
};

}  // namespace

ContactSolution solve_boundary_elements(const ContactProblem& problem, const ContactInfluence& influence,
                                        Observer& observer) {
    ContactSolution solution = BoundaryElements(problem, influence).solve(observer);
    if (!problem.derivatives) return solution;
    if (solution.converged())
        differentiate(problem, influence, observer, solution);
    else
        solution.warnings.push_back("The solution did not converge, so it has no derivatives.");
    return solution;
}

}  // namespace contactd
