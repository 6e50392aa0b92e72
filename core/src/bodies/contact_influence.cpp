#include "contactd/contact_influence.hpp"

#include <optional>

#include "contactd/convolution.hpp"
#include "contactd/shifted_operator.hpp"

namespace contactd {
namespace {

/// Those of the bodies' materials, with the singularity that the bodies have under a load.
std::optional<HalfSpaces> nearest_half_spaces(const Bodies& bodies) {
    if (bodies.pair) return {};
    HalfSpaces half_spaces{bodies.materials(), LoadShape::constant, line_contact_of(bodies)};
    for (const Body* body : {&bodies.upper, &bodies.lower})
        if (const Ics* ics = body->computed()) half_spaces.load_shape = ics->load_shape;
    return half_spaces;
}

bool have_closed_form(const Bodies& bodies) {
    if (bodies.any_given()) return false;
    for (const Body* body : {&bodies.upper, &bodies.lower})
        if (const Ics* ics = body->computed(); ics != nullptr && ics->source != IcSource::analytic) return false;
    return true;
}

}  // namespace

std::size_t ContactInfluence::bytes() const {
    return (here ? here->bytes() : 0) + (change ? change->bytes() : 0);
}

ContactInfluence make_influence(const ContactProblem& problem, const IcTable& pair) {
    const Grid& grid = problem.grid;
    ContactInfluence influence;
    influence.here = std::make_shared<const ConvolutionOperator>(pair, grid.nx, grid.ny);
    const auto [x, y] = step_of(problem);
    if (x == 0 && y == 0) return influence;
    const std::optional<HalfSpaces> nearest = nearest_half_spaces(problem.bodies);
    const ShiftedTable ahead = have_closed_form(problem.bodies) ? shifted_half_spaces(*nearest, grid, x, y)
                                                               : shifted_table(pair, nearest, grid, x, y);
    influence.change = std::make_shared<const ShiftedOperator>(change_over_step(pair, ahead));
    return influence;
}

}  // namespace contactd
