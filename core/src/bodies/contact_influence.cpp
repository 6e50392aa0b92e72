#include "contactd/contact_influence.hpp"

#include <cmath>
#include <optional>

#include "contactd/convolution.hpp"
#include "contactd/shifted_operator.hpp"

namespace contactd {

std::size_t ContactInfluence::bytes() const {
    return (here ? here->bytes() : 0) + (change ? change->bytes() : 0);
}

std::array<double, 2> step_of(const ContactProblem& problem) {
    if (!problem.friction) return {0, 0};
    const auto* rolling = std::get_if<Rolling>(&problem.friction->motion);
    if (rolling == nullptr) return {0, 0};
    const double dq = step_length(*rolling, problem.grid);
    return {dq * std::cos(rolling->chi), dq * std::sin(rolling->chi)};
}

ContactInfluence make_influence(const ContactProblem& problem, const IcTable& pair) {
    const Grid& grid = problem.grid;
    ContactInfluence influence;
    influence.here = std::make_shared<const ConvolutionOperator>(pair, grid.nx, grid.ny);
    const auto [x, y] = step_of(problem);
    if (x == 0 && y == 0) return influence;
    std::optional<HalfSpaces> half_spaces;
    if (!problem.given_ics) half_spaces = HalfSpaces{problem.bodies, problem.ics.load_shape, problem.ics.line_contact};
    const bool closed_form = half_spaces && problem.ics.source == IcSource::analytic;
    const ShiftedTable ahead =
        closed_form ? shifted_half_spaces(*half_spaces, grid, x, y) : shifted_table(pair, half_spaces, grid, x, y);
    influence.change = std::make_shared<const ShiftedOperator>(change_over_step(pair, ahead));
    return influence;
}

}  // namespace contactd
