#include "uniqueness.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "types/number_text.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

constexpr int products = 20;  // products of the power iteration, for an error below a tenth

/// Returns a lower bound of the largest compliance to tangential tractions on the elements in contact (mm^3/N), by
/// power iteration.
double largest_compliance(const InfluenceOperator& influence, const ContactSolution& solution,
                          const Observer& observer) {
    const std::size_t n = solution.pressure.size();
    Values px(n), py(n), ux(n), uy(n);
    for (std::size_t i = 0; i < n; ++i) px[i] = solution.pressure[i] > 0 ? 1 : 0;
    double norm = 0;
    for (int k = 0; k < products; ++k) {
        observer.throw_if_cancelled();
        double square = 0;
        for (std::size_t i = 0; i < n; ++i) square += px[i] * px[i] + py[i] * py[i];
        const double length = std::sqrt(square);
        if (k > 0) norm = length;
        if (!(length > 0)) return 0;
        for (Values* p : {&px, &py})
            for (double& value : *p) value /= length;
        influence.tangential(px, py, ux, uy);
        for (std::size_t i = 0; i < n; ++i) {
            const bool touches = solution.pressure[i] > 0;
            px[i] = touches ? ux[i] : 0;
            py[i] = touches ? uy[i] : 0;
        }
    }
    return norm;
}

bool is_steady(const ContactProblem& problem) {
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    return rolling != nullptr && rolling->steady();
}

/// Returns the slip velocity per slip in the arrays of the solution, which is relative in rolling.
double velocity_per_slip(const ContactProblem& problem) {
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    return rolling != nullptr ? rolling->velocity : 1 / std::get<Shift>(problem.motion).duration;
}

/// Returns the steepest fall of the traction bound with the slip velocity where elements slip (N s/mm^3).
double largest_fall(const ContactProblem& problem, const ContactSolution& solution) {
    const KineticFriction& kinetic = *problem.friction->kinetic;
    const double to_velocity = velocity_per_slip(problem);
    double largest = 0;
    for (std::size_t i = 0; i < solution.pressure.size(); ++i) {
        if (solution.element_division[i] < ElementState::slip) continue;
        const double v = to_velocity * std::hypot(solution.slip_x[i], solution.slip_y[i]);
        const double step = 1e-4 * std::max(v, kinetic.slip_velocity), mu = problem.friction->mu_of(i);
        const double fall = friction_coefficient(kinetic, mu, v) - friction_coefficient(kinetic, mu, v + step);
        largest = std::max(largest, solution.pressure[i] * fall / step);
    }
    return largest;
}

/// Returns the compliance to slip per distance rolled (mm^2/N), for any step: 2 (1 - nu)/G for two equal half-spaces.
double rolling_compliance(const Bodies& bodies) {
    double sum = 0;
    for (const Body* body : {&bodies.upper, &bodies.lower}) {
        if (body->computed() == nullptr || body->material.is_rigid()) continue;
        const double creep = body->viscoelastic ? body->viscoelastic->f : 0;
        sum += (1 + creep) * (1 - body->material.nu) / body->material.G;
    }
    return sum;
}

}  // namespace

double loop_gain(const ContactProblem& problem, const InfluenceOperator& influence, const ContactSolution& solution,
                 const Observer& observer) {
    if (!problem.friction || solution.elements.contact == 0) return 0;
    const auto& [layer, kinetic] = std::tie(problem.friction->layer, problem.friction->kinetic);
    const bool softens = layer && layer->hardens() && layer->hardening < 0 && !is_steady(problem);
    const bool falls = kinetic && !kinetic->memory;
    const double fall = falls ? largest_fall(problem, solution) : 0;
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (is_steady(problem)) return rolling->velocity * fall * rolling_compliance(problem.bodies);
    if (!softens && !(fall > 0)) return 0;
    const double per_slip =
        rolling != nullptr ? rolling->velocity / step_length(*rolling, problem.grid) : velocity_per_slip(problem);
    const double softening = softens ? -layer->hardening : 0;
    return largest_compliance(influence, solution, observer) * std::max(softening, fall * per_slip);
}

std::vector<std::string> friction_warnings(const ContactProblem& problem, const InfluenceOperator& influence,
                                           const ContactSolution& solution, const Observer& observer) {
    std::vector<std::string> warnings;
    if (!problem.friction || problem.model != Model::full) return warnings;
    if (const auto& outer = solution.evidence.outer; outer && !outer->converged && influence.coupled())
        warnings.push_back("The outer iterations between pressures and tractions stopped after " +
                           std::to_string(outer->iterations) +
                           " without convergence. Bodies of different materials may have several solutions in a step "
                           "that is not steady. Try a shorter step or smaller elements.");
    if (const double gain = loop_gain(problem, influence, solution, observer); gain > 1)
        warnings.push_back(
            "Several solutions are possible: falling friction or softening feeds back on the slip with a gain of " +
            short_text(gain) +
            ", and the solution is unique only below 1. Set friction.kinetic.memory, or reduce the softening.");
    const auto& kinetic = problem.friction->kinetic;
    if (!kinetic || !kinetic->memory) return warnings;
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    const double unit = rolling != nullptr ? step_length(*rolling, problem.grid) : 1;
    double longest = 0;
    for (std::size_t i = 0; i < solution.slip_x.size(); ++i)
        longest = std::max(longest, unit * std::hypot(solution.slip_x[i], solution.slip_y[i]));
    if (longest > kinetic->memory->distance)
        warnings.push_back("Particles slip by up to " + short_text(longest) +
                           " mm in a step, more than the distance of friction.kinetic.memory, " +
                           number_text(kinetic->memory->distance) +
                           " mm. The step does not resolve the memory. Use smaller elements or a shorter step.");
    return warnings;
}

}  // namespace contactd
