#include "rotated_influence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>
#include <vector>

#include "contactd/half_space.hpp"
#include "influence/shifted_half_space.hpp"
#include "operators/rotated/rotated_coefficients.hpp"
#include "operators/strips/strip_operator.hpp"
#include "operators/strips/strip_step.hpp"
#include "step_along_strips.hpp"

namespace contactd {
namespace {

/// Returns how much products may change a coefficient, over zz of an element on itself. It is zero for patches whose
/// symbols fit into the nearest caches, because nothing is gained there.
double change_of_coefficients(const Grid& grid) {
    constexpr double few = 16'384;  // number of offsets along x times pairs of rows
    return static_cast<double>(grid.nx) * grid.ny * grid.ny > few ? largest_change : 0;
}

IcTable pair_table(const ContactProblem& problem, int nx, const Observer& observer) {
    const auto table_of = [&](const Material& material) -> IcTable {
        if (material.is_rigid()) return {nx, problem.grid.ny};
        IcSpec spec;
        spec.material = material;
        spec.dx = problem.grid.dx;
        spec.dy = problem.grid.dy;
        spec.nx = nx;
        spec.ny = problem.grid.ny;
        return half_space_table(spec, observer);
    };
    const auto [upper, lower] = problem.bodies.materials();
    IcTable table = table_of(upper);
    if (upper == lower) return pair_of(table, table);
    return pair_of(std::move(table), table_of(lower));
}

/// Returns all six components of MidwayKernels.
std::array<double, 6> six_values(const HalfSpaceModel& model, const KernelIntegrals& integrals) {
    using enum Axis;
    return {model.coefficient(x, x, integrals), model.coefficient(x, y, integrals),
            model.coefficient(y, y, integrals), model.a * (integrals.xx + integrals.yy) / (2 * std::numbers::pi),
            model.coefficient(y, z, integrals), model.coefficient(x, z, integrals)};
}

/// Returns the coefficients minus those a step (mm) ahead, divided into the parts with the same and with the opposite
/// parity along x.
std::pair<MidwayKernels::Values, MidwayKernels::Values> change_over(double step, const HalfSpaceModel& model,
                                                                    const Grid& grid, const Observer& observer) {
    MidwayKernels::Values natural, opposite;
    for (auto* values : {&natural, &opposite})
        for (auto& component : *values) component.resize(grid.size());
    const auto index = [&](int k, int l) {
        return static_cast<std::size_t>(l) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(std::abs(k));
    };
    const Lattice here{grid.dx, grid.dy, 0, grid.nx - 1, 0, grid.ny - 1, 0, 0},
        ahead{grid.dx, grid.dy, 1 - grid.nx, grid.nx - 1, 0, grid.ny - 1, step / grid.dx, 0};
    for_lattice(model, here, observer, [&](int k, int l, const KernelIntegrals& integrals) {
        const auto values = six_values(model, integrals);
        for (std::size_t c = 0; c < values.size(); ++c) natural[c][index(k, l)] = values[c];
    });
    for_lattice(model, ahead, observer, [&](int k, int l, const KernelIntegrals& integrals) {
        const auto values = six_values(model, integrals);
        for (std::size_t c = 0; c < values.size(); ++c) {
            const double sign = c == MidwayKernels::xs || c == MidwayKernels::xn ? -1 : 1;
            const std::size_t at = index(k, l);
            // The offset 0 has no sign and counts for both.
            if (k >= 0) {
                natural[c][at] -= 0.5 * values[c];
                opposite[c][at] -= 0.5 * values[c];
            }
            if (k <= 0) {
                natural[c][at] -= 0.5 * sign * values[c];
                opposite[c][at] += 0.5 * sign * values[c];
            }
        }
    });
    return {std::move(natural), std::move(opposite)};
}

}  // namespace

MidwayInfluence midway_influence(const ContactProblem& problem, ContactInfluence flat, const Observer& observer) {
    const Grid& grid = problem.grid;
    const StepAlongStrips step = step_along_strips(problem);
    const bool whole = step.fraction == 0;
    MidwayInfluence midway{std::move(flat), {}, {}, {}};
    midway.current =
        std::make_shared<const MidwayKernels>(pair_table(problem, grid.nx + (whole ? step.reach() : 0), observer));
    if (whole) return midway;
    const HalfSpaceModel model(HalfSpaces{problem.bodies.materials()});
    auto [natural, opposite] = change_over(step_of(problem)[0], model, grid, observer);
    const auto kernels = [&](MidwayKernels::Values values, OffsetParity parity) {
        return std::make_shared<const MidwayKernels>(grid.nx, grid.ny, std::move(values), model.coupled(), parity);
    };
    midway.natural = kernels(std::move(natural), OffsetParity::natural);
    midway.opposite = kernels(std::move(opposite), OffsetParity::opposite);
    return midway;
}

ContactInfluence rotated_influence(const ContactProblem& problem, const MidwayInfluence& midway,
                                   std::span<const StripFrame> frames) {
    std::vector<double> angles;
    for (const StripFrame& frame : frames) angles.push_back(frame.angle);
    const double left_out = change_of_coefficients(problem.grid) * midway.current->at_origin(MidwayKernels::nn);
    const auto parts_of = [&](const std::shared_ptr<const MidwayKernels>& kernels, OffsetParity parity) {
        const double share =
            kernels == midway.current ? 1 : std::min(1.0, std::abs(step_of(problem)[0]) / problem.grid.dx);
        return std::make_shared<const StripParts>(std::make_shared<const RotatedCoefficients>(kernels, angles),
                                                  problem.grid.nx, parity, share * left_out);
    };
    const auto parts = parts_of(midway.current, OffsetParity::natural);
    ContactInfluence influence;
    influence.current = std::make_shared<const StripOperator>(parts, parts->extent(), midway.flat.current);
    if (!midway.flat.increment) return influence;
    if (midway.natural)
        influence.increment =
            std::make_shared<const StripStep>(StripIncrement{parts_of(midway.natural, OffsetParity::natural),
                                                             parts_of(midway.opposite, OffsetParity::opposite)},
                                              parts->extent(), parts->coupled(), midway.flat.increment);
    else
        influence.increment = std::make_shared<const StripStep>(
            parts, parts->extent(), step_along_strips(problem).whole, midway.flat.increment);
    return influence;
}

}  // namespace contactd
