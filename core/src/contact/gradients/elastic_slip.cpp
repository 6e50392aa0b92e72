#include "elastic_slip.hpp"

#include <utility>

#include "contact/rolling/transposed_step.hpp"
#include "contact/support/entering_particles.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

const Rolling* rolling_of(const ContactProblem& problem) {
    return problem.friction ? std::get_if<Rolling>(&problem.motion) : nullptr;
}

bool is_steady(const ContactProblem& problem) {
    const Rolling* rolling = rolling_of(problem);
    return rolling != nullptr && rolling->steady();
}

EnteringParticles entering_of(const ContactProblem& problem, const ContactSolution& solution) {
    if (rolling_of(problem) == nullptr || is_steady(problem)) return {};
    return entering_particles(problem.grid, solution.pressure, step_of(problem));
}

Values or_zeros(const Values& values, std::size_t size) {
    return values.empty() ? Values(size) : values;
}

/// Adds factor K p of one operator, from tractions to `slip` and from pressures to `coupling`.
template <class Operator>
void add_slip(const Operator& influence, const Values& x, const Values& y, const Values& p, double factor, Field& slip,
              Field& coupling) {
    Field u(x.size());
    influence.tangential(x, y, u.x, u.y);
    add(slip, u, factor);
    if (!influence.coupled()) return;
    influence.tangential_of_normal(p, u.x, u.y);
    add(coupling, u, factor);
}

/// Particles that enter during a step had the displacements of their point of entry, see TangentialStep.
void move_entering(const EnteringParticles& entering, const Field& same_place, Field& history) {
    for (std::size_t i = 0; i < entering.part.size(); ++i) {
        if (entering.part[i] == 1) continue;
        history.x[i] = same_place.x[entering.from[i]];
        history.y[i] = same_place.y[entering.from[i]];
    }
}

void add_history(const ContactProblem& problem, const ContactInfluence& influence, const ContactSolution& solution,
                 ElasticEffects& effects) {
    if (problem.previous.empty() || is_steady(problem)) return;
    const std::size_t n = problem.grid.size();
    const Values x = or_zeros(problem.previous.traction_x, n), y = or_zeros(problem.previous.traction_y, n),
                 p = or_zeros(problem.previous.pressure, n);
    Field slip(n), coupling(n);
    add_slip(*influence.current, x, y, p, -1, slip, coupling);
    const Field same_slip = slip, same_coupling = coupling;
    if (rolling_of(problem) != nullptr) add_slip(*influence.increment, x, y, p, 1, slip, coupling);
    const EnteringParticles entering = entering_of(problem, solution);
    move_entering(entering, same_slip, slip);
    move_entering(entering, same_coupling, coupling);
    add(effects.slip, slip);
    add(effects.slip_by_coupling, coupling);
}

}  // namespace

ElasticEffects elastic_effects(const ContactProblem& problem, const ContactInfluence& influence,
                               const ContactSolution& solution) {
    const std::size_t n = problem.grid.size();
    ElasticEffects effects{Field(n), Field(n), Values(n), Values(n)};
    const Values &x = solution.traction_x, &y = solution.traction_y, &p = solution.pressure;
    influence.current->normal(p, effects.normal);
    if (!problem.friction) return effects;
    if (influence.current->coupled()) influence.current->normal_of_tangential(x, y, effects.normal_by_coupling);
    if (is_steady(problem))
        add_slip(*influence.increment, x, y, p, 1, effects.slip, effects.slip_by_coupling);
    else
        add_slip(*influence.current, x, y, p, 1, effects.slip, effects.slip_by_coupling);
    add_history(problem, influence, solution, effects);
    return effects;
}

// History is -A' p_old, with A' = A - C, and -A p_old at the point of entry for particles that enter.
GradientByPrevious by_previous(const ContactProblem& problem, const ContactInfluence& influence,
                               const ContactSolution& solution, const Field& slip) {
    const std::size_t n = problem.grid.size();
    GradientByPrevious result{Values(n), Values(n), Values(n)};
    if (!problem.friction || is_steady(problem)) return result;
    Field rest = slip, all = slip;
    const EnteringParticles entering = entering_of(problem, solution);
    for (std::size_t i = 0; i < entering.part.size(); ++i) {
        if (entering.part[i] == 1) continue;
        for (const auto& [from, to] : {std::pair{&rest.x, &all.x}, {&rest.y, &all.y}}) {
            const double value = std::exchange((*from)[i], 0);
            (*to)[i] -= value;
            (*to)[entering.from[i]] += value;
        }
    }
    Field traction(n);
    influence.current->tangential(all.x, all.y, traction.x, traction.y);
    Values pressure(n);
    const bool coupled = influence.current->coupled();
    if (coupled) influence.current->normal_of_tangential(all.x, all.y, pressure);
    if (rolling_of(problem) != nullptr) {
        const auto axes = problem.bodies.any_uniform() ? Reflection::Axes::along_x : Reflection::Axes::both;
        TransposedStep step(*influence.increment, problem.grid, axes);
        Field ahead(n);
        step.tangential(rest, ahead);
        add(traction, ahead, -1);
        Values pressed(n);
        if (coupled) step.pressures(rest, pressed);
        for (std::size_t i = 0; i < n; ++i) pressure[i] -= pressed[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
        result.pressure[i] = -pressure[i];
        result.traction_x[i] = -traction.x[i];
        result.traction_y[i] = -traction.y[i];
    }
    return result;
}

}  // namespace contactd
