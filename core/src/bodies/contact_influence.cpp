#include "contactd/contact_influence.hpp"

#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "contactd/half_space.hpp"
#include "influence/layered/shifted_layers.hpp"
#include "operators/convolution.hpp"
#include "operators/shifted_operator.hpp"
#include "operators/strips/table_coefficients.hpp"
#include "operators/sum_operator.hpp"
#include "operators/sum_step.hpp"
#include "operators/viscoelastic/viscoelastic_operator.hpp"
#include "strip_influence.hpp"
#include "uniform_strips.hpp"
#include "viscoelastic_influence.hpp"

namespace contactd {
namespace {

/// Returns the half-spaces of the bodies' materials, which have the same singularity under a load as the bodies.
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

ShiftedTable ahead_of(const ContactProblem& problem, const IcTable& pair, double x, double y,
                      const Observer& observer) {
    const std::optional<HalfSpaces> nearest = nearest_half_spaces(problem.bodies);
    return have_closed_form(problem.bodies) ? shifted_half_spaces(*nearest, problem.grid, x, y, observer)
                                            : shifted_table(pair, nearest, problem.grid, x, y, observer);
}

ShiftedTable ahead_of(const ContactProblem& problem, const Body& body, const IcTable& table, double x, double y,
                      const Observer& observer) {
    const Ics* ics = body.computed();
    if (ics != nullptr && ics->layered)
        return shifted_layers(*ics->layered, ics->load_shape, problem.grid, x, y, observer);
    if (body.material.is_rigid()) return {problem.grid.nx, problem.grid.ny};
    ContactProblem alone = problem;
    alone.bodies = {{Material::rigid()}, body};
    return ahead_of(alone, table, x, y, observer);
}

/// Returns the change of coefficients over a step. If one body has layers, the tables of both are shifted separately,
/// because the difference of layers to a half-space is the sharper the thinner they are.
ShiftedTable change_of(const ContactProblem& problem, const IcTable& pair, const IcTable& upper, const IcTable& lower,
                       const Observer& observer) {
    const auto [x, y] = step_of(problem);
    const ShiftedTable above = ahead_of(problem, problem.bodies.upper, upper, x, y, observer);
    ShiftedTable ahead = ahead_of(problem, problem.bodies.lower, lower, x, y, observer);
    const std::size_t size = ahead.component_size();
    for (std::size_t i = 0; i < ahead.values.size(); ++i) {
        const bool normal_load = i / size % 3 == static_cast<std::size_t>(Axis::z);
        ahead.values[i] += normal_load ? -above.values[i] : above.values[i];
    }
    return change_over_step(pair, ahead);
}

/// Creates the operators, including that of the change over a step if there is one.
ContactInfluence influence_of(const ContactProblem& problem, IcTable pair, std::optional<ShiftedTable> change) {
    const Grid& grid = problem.grid;
    ContactInfluence influence;
    if (change) influence.increment = std::make_shared<const ShiftedOperator>(*std::move(change));
    if (pair.nx == grid.nx && pair.ny == grid.ny)
        influence.current = std::make_shared<const ConvolutionOperator>(std::move(pair));
    else
        influence.current = std::make_shared<const ConvolutionOperator>(pair, grid.nx, grid.ny);
    return influence;
}

ContactInfluence influence_of(const ContactProblem& problem, StripTable upper, StripTable lower,
                              const Observer& observer) {
    if (problem.bodies.upper.material.is_rigid()) return strip_influence(problem, std::move(lower), observer);
    if (problem.bodies.lower.material.is_rigid()) lower = StripTable(upper.nx, upper.strips);
    return strip_influence(problem, pair_of(upper, std::move(lower), observer), observer);
}

ContactInfluence influence_of(const ContactProblem& problem, IcTable upper, const IcTable& lower,
                              const Observer& observer) {
    const auto [x, y] = step_of(problem);
    if (!problem.bodies.any_layered() || (x == 0 && y == 0))
        return make_influence(problem, pair_of(std::move(upper), lower), observer);
    IcTable pair = pair_of(upper, lower);
    ShiftedTable change = change_of(problem, pair, upper, lower, observer);
    return influence_of(problem, std::move(pair), std::optional(std::move(change)));
}

/// Creates the operators of one body alone, as if it lay below a rigid one. A rigid body has none.
ContactInfluence influence_alone(const ContactProblem& problem, const Body& body, IcTable table, bool /*is_upper*/,
                                 const Observer& observer) {
    if (body.material.is_rigid()) return {};
    ContactProblem alone = problem;
    alone.bodies = {{Material::rigid()}, body};
    return make_influence(alone, std::move(table), observer);
}

/// The upper body is reflected in the plane of contact, and its strips are numbered like those of the lower body.
ContactInfluence influence_alone(const ContactProblem& problem, const Body& body, StripTable table, bool is_upper,
                                 const Observer& observer) {
    if (body.material.is_rigid()) return {};
    ContactProblem alone = problem;
    alone.bodies = {{Material::rigid()}, body};
    return strip_influence(alone, is_upper ? mirrored(table, observer) : std::move(table), observer);
}

bool is_closed_half_space(const Body& body) {
    const Ics* ics = body.computed();
    return ics != nullptr && ics->source == IcSource::analytic && ics->body == BodyShape::half_space &&
           ics->load_shape == LoadShape::constant && !ics->line_contact;
}

/// Returns a half-space as strips like those of a longitudinally uniform body's table. One product with both costs a
/// third of two products.
StripTable half_space_strips(const ContactProblem& problem, const Body& body, const StripTable& beside,
                             const Observer& observer) {
    IcSpec spec;
    spec.material = body.material;
    spec.dx = problem.grid.dx;
    spec.dy = problem.grid.dy;
    spec.nx = beside.nx;
    spec.ny = beside.strips;
    return strip_table_of(half_space_table(spec, observer));
}

/// Creates the operators of bodies of which only one has strips.
template <class Upper, class Lower>
ContactInfluence influence_of_two_kinds(const ContactProblem& problem, Upper upper, Lower lower,
                                        const Observer& observer) {
    const auto& [above, below, pair] = problem.bodies;
    if constexpr (std::is_same_v<Upper, StripTable>) {
        if (!above.material.is_rigid() && is_closed_half_space(below) && !below.material.is_rigid()) {
            StripTable strips = half_space_strips(problem, below, upper, observer);
            return influence_of(problem, std::move(upper), std::move(strips), observer);
        }
    } else {
        if (!below.material.is_rigid() && is_closed_half_space(above) && !above.material.is_rigid()) {
            StripTable strips = half_space_strips(problem, above, lower, observer);
            return influence_of(problem, std::move(strips), std::move(lower), observer);
        }
    }
    return sum_of(influence_alone(problem, above, std::move(upper), true, observer),
                  influence_alone(problem, below, std::move(lower), false, observer));
}

}  // namespace

std::size_t ContactInfluence::bytes() const {
    return (current ? current->bytes() : 0) + (increment ? increment->bytes() : 0);
}

std::size_t influence_bytes(const Grid& grid, const Bodies& bodies) {
    const std::size_t flat = grid.size() * ((bodies.any_viscoelastic() ? ViscoelasticOperator::bytes_per_element
                                                                       : ConvolutionOperator::bytes_per_element) +
                                            ShiftedOperator::bytes_per_element);
    if (!bodies.any_uniform()) return flat;
    // A step that is not of whole elements has two separate tables; a step of one element reads one more offset.
    const std::size_t strips = 3 * TableCoefficients::bytes_of(grid.nx + 1, grid.ny);
    const auto has_strips = [](const Body& body) { return body.section() != nullptr || body.material.is_rigid(); };
    return strips + (has_strips(bodies.upper) && has_strips(bodies.lower) ? flat : 2 * flat);
}

ContactInfluence make_influence(const ContactProblem& problem, IcTable pair, const Observer& observer) {
    if (problem.bodies.any_viscoelastic()) {
        ContactProblem rolling = problem;
        rolling.bodies = without_instant_creep(problem.bodies);
        return rolling.bodies.any_viscoelastic() ? viscoelastic_influence(rolling, std::move(pair), observer)
                                                 : make_influence(rolling, std::move(pair), observer);
    }
    const auto [x, y] = step_of(problem);
    if (x == 0 && y == 0) return influence_of(problem, std::move(pair), std::optional<ShiftedTable>());
    ShiftedTable change = problem.bodies.any_layered()
                              ? change_of(problem, pair, pair, pair, observer)
                              : change_over_step(pair, ahead_of(problem, pair, x, y, observer));
    return influence_of(problem, std::move(pair), std::optional(std::move(change)));
}

ContactInfluence make_influence(const ContactProblem& problem, BodyTable upper, BodyTable lower,
                                const Observer& observer) {
    check_strips_of_uniform(problem);
    if (problem.bodies.any_viscoelastic())  // Both bodies are half-spaces.
        return make_influence(problem, pair_of(std::get<IcTable>(std::move(upper)), std::get<IcTable>(lower)),
                              observer);
    return std::visit(
        [&]<class Upper, class Lower>(Upper& above, Lower& below) {
            if constexpr (std::is_same_v<Upper, Lower>)
                return influence_of(problem, std::move(above), std::move(below), observer);
            else
                return influence_of_two_kinds(problem, std::move(above), std::move(below), observer);
        },
        upper, lower);
}

ContactInfluence sum_of(const ContactInfluence& upper, const ContactInfluence& lower) {
    ContactInfluence influence;
    influence.current = std::make_shared<const SumOperator>(OfBodies<InfluenceOperator>{upper.current, lower.current});
    if (upper.increment || lower.increment)
        influence.increment = std::make_shared<const SumStep>(OfBodies<StepOperator>{upper.increment, lower.increment});
    return influence;
}

}  // namespace contactd
