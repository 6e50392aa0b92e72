#include "layer_flow.hpp"

#include <algorithm>
#include <cmath>

#include "operators/upstream.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

}  // namespace

LayerFlow::LayerFlow(const ContactProblem& problem) : problem_(problem), layer_(*problem.friction->layer) {
    task_.first = layer_.yield_stress;
    task_.hardening = layer_.hardening;
    task_.least = layer_.residual * layer_.yield_stress;
}

void LayerFlow::begin(const Values& yield_stress) {
    if (!layer_.hardens()) return;
    const auto* rolling = std::get_if<Rolling>(&problem_.motion);
    if (rolling != nullptr && rolling->steady()) return;
    task_.before = yield_stress;
    if (task_.before.empty()) task_.before.assign(problem_.grid.size(), layer_.yield_stress);
    if (rolling == nullptr) return;
    const auto [x, y] = step_of(problem_);
    task_.before = one_step_ahead(problem_.grid, x, y, task_.before, layer_.yield_stress);
}

void LayerFlow::limit(Values& bound) const {
    if (layer_.hardens()) return;
    for (double& g : bound) g = std::min(g, layer_.yield_stress);
}

// Returns the yield stress that the particle carries on from element i, where it arrived with v.
double LayerFlow::yield_stress_behind(std::size_t i, double v, double bound, double diagonal,
                                      RollingSolution& solution) const {
    const auto [first, least] = std::pair(layer_.yield_stress, layer_.residual * layer_.yield_stress);
    const double x = solution.slip_x[i], y = solution.slip_y[i], length = std::hypot(x, y);
    ElementState& state = solution.element_division[i];
    const auto flow = [&](double part) {
        solution.flow_x[i] = -part * x;
        solution.flow_y[i] = -part * y;
        solution.slip_x[i] -= part * x;
        solution.slip_y[i] -= part * y;
    };
    if (state == ElementState::exterior || state == ElementState::adhesion) return v;
    if (!layer_.hardens()) {
        if (first < bound) {
            flow(1);
            state = ElementState::flow;
        }
        return first;
    }
    if (state == ElementState::flow) {
        flow(1);
        return std::max(std::hypot(solution.traction_x[i], solution.traction_y[i]), least);
    }
    if (!(v < bound) || layer_.hardening < 0) return v;
    state = ElementState::flow;
    const double until_slip = diagonal * (bound - v) / layer_.hardening;
    flow(length > 0 ? std::min(until_slip / length, 1.0) : 0);
    return bound;
}

void LayerFlow::divide(std::span<const double> bound, RollingSolution& solution) const {
    const std::size_t n = bound.size();
    solution.flow_x.assign(n, 0);
    solution.flow_y.assign(n, 0);
    solution.yield_stress.assign(n, layer_.yield_stress);
    const auto* rolling = std::get_if<Rolling>(&problem_.motion);
    if (rolling == nullptr || !rolling->steady() || !layer_.hardens()) {
        for (std::size_t i = 0; i < n; ++i)
            if (bound[i] > 0)
                solution.yield_stress[i] = yield_stress_behind(
                    i, layer_.hardens() ? task_.before[i] : layer_.yield_stress, bound[i], 1, solution);
        return;
    }
    std::vector<std::size_t> elements;
    for (std::size_t i = 0; i < n; ++i)
        if (bound[i] > 0) elements.push_back(i);
    const auto [x, y] = step_of(problem_);
    const Upstream upstream(problem_.grid, x, y, elements);
    Values behind(elements.size());
    upstream.travel(
        layer_.yield_stress,
        [&](std::size_t e, double v) {
            const std::size_t i = elements[e];
            return yield_stress_behind(i, v, bound[i], upstream.diagonal(), solution);
        },
        behind);
    for (std::size_t e = 0; e < elements.size(); ++e) solution.yield_stress[elements[e]] = behind[e];
}

}  // namespace contactd
