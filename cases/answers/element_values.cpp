#include "element_values.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <variant>

#include "operators/upstream.hpp"

namespace contactd::cases {
namespace {

using Values = std::vector<double>;

const Rolling* rolling_of(const ContactProblem& problem) {
    return std::get_if<Rolling>(&problem.motion);
}

/// Computes values along the paths of particles in steady rolling: value(i, v) in element i, where v arrives there.
template <class Value>
Values swept(const ContactProblem& problem, double entering, const Value& value) {
    std::vector<std::size_t> elements(problem.grid.size());
    std::iota(elements.begin(), elements.end(), std::size_t{0});
    const auto [x, y] = step_of(problem);
    const Upstream upstream(problem.grid, x, y, elements);
    Values found(elements.size());
    upstream.travel(entering, value, found);
    return found;
}

Values accumulated(const ContactProblem& problem, const ContactSolution& solution, const Values& flow,
                   const Values& before) {
    const Rolling* rolling = rolling_of(problem);
    const double step = rolling ? step_length(*rolling, problem.grid) : 1;
    if (rolling && rolling->steady())
        return swept(problem, 0, [&](std::size_t i, double brought) { return brought + step * flow[i]; });
    Values sum = before.empty() ? Values(flow.size()) : before;
    if (rolling && !before.empty()) {
        const auto [x, y] = step_of(problem);
        sum = one_step_ahead(problem.grid, x, y, before, 0);
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] = solution.element_division[i] == ElementState::exterior ? 0 : sum[i] + step * flow[i];
    return sum;
}

/// Replaces Hertz's pressures by a paraboloid with the same force, whose maximum is 4/3 of theirs.
void take_paraboloid(ContactSolution& solution) {
    const double p0 = solution.pmax;
    if (!(p0 > 0)) return;
    for (double& p : solution.pressure) p *= 4.0 / 3 * p / p0;
}

void take_areas(const Grid& grid, ContactSolution& solution) {
    const auto area_of = [&](ElementState state) {
        return static_cast<double>(std::ranges::count(solution.element_division, state)) * grid.element_area();
    };
    solution.area.adhesion = area_of(ElementState::adhesion);
    solution.area.slip = area_of(ElementState::slip);
    solution.area.flow = area_of(ElementState::flow);
    solution.area.contact = solution.area.adhesion + solution.area.slip + solution.area.flow;
}

}  // namespace

void take_elements(const ContactProblem& problem, ContactSolution& solution, bool rubs) {
    const bool is_simplified = problem.model == Model::fastsim || problem.model == Model::fastrip;
    const bool in_ellipse = is_simplified && problem.normal_model == NormalModel::of_model;
    if (in_ellipse) {
        if (problem.model == Model::fastsim && problem.simplified.bound == TractionBound::parabolic)
            take_paraboloid(solution);
        if (!solution.pressure.empty()) solution.pmax = std::ranges::max(solution.pressure);
    }
    const bool is_prescribed =
        problem.normal_model == NormalModel::elliptic || problem.normal_model == NormalModel::parabolic;
    if (is_prescribed && problem.Fn) solution.forces.Fn = *problem.Fn;
    if (!rubs) std::ranges::replace(solution.element_division, ElementState::slip, ElementState::adhesion);
    const bool flows = !solution.flow_x.empty();
    for (std::size_t i = 0; flows && i < solution.element_division.size(); ++i) {
        ElementState& state = solution.element_division[i];
        const bool slips = solution.slip_x[i] != 0 || solution.slip_y[i] != 0;
        if (state == ElementState::flow && slips) state = ElementState::slip;
    }
    if (in_ellipse || flows || !rubs) take_areas(problem.grid, solution);
}

PlasticSlip plastic_slip(const ContactProblem& problem, const ContactSolution& solution, const PlasticSlip& before) {
    if (solution.flow_x.empty()) return {};
    return {accumulated(problem, solution, solution.flow_x, before.x),
            accumulated(problem, solution, solution.flow_y, before.y)};
}

std::vector<double> yield_stress(const ContactProblem& problem, const ContactSolution& solution) {
    const Rolling* rolling = rolling_of(problem);
    const bool stays = solution.yield_stress.empty() && !solution.flow_x.empty();
    if (stays) return Values(problem.grid.size(), problem.friction->layer->yield_stress);
    if (solution.yield_stress.empty() || !rolling || !rolling->steady()) return solution.yield_stress;
    return swept(problem, problem.friction->layer->yield_stress, [&](std::size_t i, double brought) {
        return solution.element_division[i] == ElementState::exterior ? brought : solution.yield_stress[i];
    });
}

}  // namespace contactd::cases
