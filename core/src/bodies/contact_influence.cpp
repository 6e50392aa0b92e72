#include "contactd/contact_influence.hpp"

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "operators/convolution.hpp"
#include "operators/shifted_operator.hpp"
#include "operators/sum_operator.hpp"
#include "operators/sum_step.hpp"

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

ShiftedTable change_of(const ContactProblem& problem, const IcTable& pair, double x, double y) {
    const std::optional<HalfSpaces> nearest = nearest_half_spaces(problem.bodies);
    const ShiftedTable ahead = have_closed_form(problem.bodies) ? shifted_half_spaces(*nearest, problem.grid, x, y)
                                                                : shifted_table(pair, nearest, problem.grid, x, y);
    return change_over_step(pair, ahead);
}

/// Of one body alone, as if it lay below a rigid one; none of a rigid body.
template <class Table>
ContactInfluence influence_of(const ContactProblem& problem, const Body& body, Table table) {
    if (body.material.is_rigid()) return {};
    ContactProblem alone = problem;
    alone.bodies = {{Material::rigid()}, body};
    return make_influence(alone, std::move(table));
}

}  // namespace

std::size_t ContactInfluence::bytes() const {
    return (here ? here->bytes() : 0) + (change ? change->bytes() : 0);
}

std::size_t influence_bytes(std::size_t elements) {
    return elements * (ConvolutionOperator::bytes_per_element + ShiftedOperator::bytes_per_element);
}

ContactInfluence make_influence(const ContactProblem& problem, IcTable pair) {
    const Grid& grid = problem.grid;
    ContactInfluence influence;
    if (const auto [x, y] = step_of(problem); x != 0 || y != 0)
        influence.change = std::make_shared<const ShiftedOperator>(change_of(problem, pair, x, y));
    if (pair.nx == grid.nx && pair.ny == grid.ny)
        influence.here = std::make_shared<const ConvolutionOperator>(std::move(pair));
    else
        influence.here = std::make_shared<const ConvolutionOperator>(pair, grid.nx, grid.ny);
    return influence;
}

ContactInfluence make_influence(const ContactProblem& problem, BodyTable upper, BodyTable lower) {
    return std::visit(
        [&]<class Upper, class Lower>(Upper& above, Lower& below) {
            if constexpr (std::is_same_v<Upper, Lower>)
                return make_influence(problem, pair_of(std::move(above), below));
            else
                return sum_of(influence_of(problem, problem.bodies.upper, std::move(above)),
                              influence_of(problem, problem.bodies.lower, std::move(below)));
        },
        upper, lower);
}

ContactInfluence sum_of(const ContactInfluence& upper, const ContactInfluence& lower) {
    ContactInfluence influence;
    influence.here = std::make_shared<const SumOperator>(OfBodies<InfluenceOperator>{upper.here, lower.here});
    if (upper.change || lower.change)
        influence.change = std::make_shared<const SumStep>(OfBodies<StepOperator>{upper.change, lower.change});
    return influence;
}

}  // namespace contactd
