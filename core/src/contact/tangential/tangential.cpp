#include "tangential.hpp"

#include <algorithm>
#include <cmath>

#include "contact/support/contact_elements.hpp"
#include "contact/support/solver_support.hpp"
#include "operators/restriction.hpp"
#include "tang_cg.hpp"

namespace contactd {
namespace {

Field on_box(const Restriction& restriction, std::span<const double> x, std::span<const double> y, std::size_t n) {
    const std::vector<double> none(x.empty() || y.empty() ? n : 0);
    Field field;
    field.x = restriction.crop(x.empty() ? none : x);
    field.y = restriction.crop(y.empty() ? none : y);
    return field;
}

}  // namespace

TangentialSolution solve_tangential(const InfluenceOperator& influence, std::span<const double> bound,
                                    std::span<const double> rigid_x, std::span<const double> rigid_y,
                                    const SolverSettings& settings, std::span<const double> initial_x,
                                    std::span<const double> initial_y, Observer& observer) {
    require_size(bound, influence.size(), "bound");
    require_size(rigid_x, influence.size(), "rigid_x");
    require_size(rigid_y, influence.size(), "rigid_y");
    if (!initial_x.empty()) require_size(initial_x, influence.size(), "initial.traction_x");
    if (!initial_y.empty()) require_size(initial_y, influence.size(), "initial.traction_y");
    const Stopwatch stopwatch;
    const Restriction restriction(
        influence, bounding_box(extent_of(influence), [&](std::size_t i) { return bound[i] > 0; }), false);
    const Contact contact(restriction.crop(bound), restriction.crop(rigid_x), restriction.crop(rigid_y));
    TangCg solver(restriction.influence(), contact, settings, observer);
    solver.start(on_box(restriction, initial_x, initial_y, influence.size()));
    const TangentialSolution part = solver.solve();
    TangentialSolution solution;
    solution.traction_x.resize(influence.size());
    solution.traction_y.resize(influence.size());
    solution.element_division.assign(influence.size(), ElementState::exterior);
    restriction.paste(part.traction_x, solution.traction_x);
    restriction.paste(part.traction_y, solution.traction_y);
    restriction.paste(part.element_division, solution.element_division);
    solution.evidence = part.evidence;
    solution.evidence.seconds = stopwatch.seconds();
    return solution;
}

}  // namespace contactd
