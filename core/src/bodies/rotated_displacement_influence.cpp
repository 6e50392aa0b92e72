#include "rotated_displacement_influence.hpp"

#include <memory>
#include <utility>

#include "contactd/half_space.hpp"
#include "influence/shifted_table.hpp"
#include "operators/convolution.hpp"
#include "operators/rotated/rotated_operator.hpp"
#include "operators/rotated/rotated_step.hpp"
#include "operators/shifted_operator.hpp"

namespace contactd {
namespace {

IcTable half_space(const ContactProblem& problem, const Body& body, const Observer& observer) {
    const Grid& grid = problem.grid;
    if (body.material.is_rigid()) return {grid.nx, grid.ny};
    IcSpec spec;
    spec.material = body.material;
    spec.dx = grid.dx;
    spec.dy = grid.dy;
    spec.nx = grid.nx;
    spec.ny = grid.ny;
    return half_space_table(spec, observer);
}

}  // namespace

ContactInfluence rotated_displacement_influence(const ContactProblem& problem, std::span<const double> angles,
                                                const Observer& observer) {
    const Grid& grid = problem.grid;
    const RowRotations rotations(angles, grid.nx);
    const IcTable flat = pair_of(half_space(problem, problem.bodies.upper, observer),
                                 half_space(problem, problem.bodies.lower, observer));
    ContactInfluence influence;
    influence.current = std::make_shared<const RotatedOperator>(
        std::make_shared<const ConvolutionOperator>(flat, grid.nx, grid.ny), rotations);
    const double step = step_of(problem)[0];
    if (step == 0) return influence;
    const MaterialPair bodies = problem.bodies.materials();
    auto along = std::make_shared<const ShiftedOperator>(
        change_over_step(flat, shifted_half_spaces({bodies}, grid, step, 0, observer)));
    influence.increment = std::make_shared<const RotatedStep>(
        std::move(along), normal_increment(bodies, grid, step, observer), rotations);
    return influence;
}

}  // namespace contactd
