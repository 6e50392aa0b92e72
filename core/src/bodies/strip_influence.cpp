#include "strip_influence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "influence/cubic_weights.hpp"
#include "influence/shifted_table.hpp"
#include "operators/convolution.hpp"
#include "operators/shifted_operator.hpp"
#include "operators/strips/strip_operator.hpp"
#include "operators/strips/strip_step.hpp"
#include "operators/strips/table_coefficients.hpp"
#include "step_along_strips.hpp"

namespace contactd {
namespace {

IcTable half_space(const ContactProblem& problem, const Body& body, int nx, const Observer& observer) {
    if (body.material.is_rigid()) return {nx, problem.grid.ny};
    IcSpec spec;
    spec.material = body.material;
    spec.dx = problem.grid.dx;
    spec.dy = problem.grid.dy;
    spec.nx = nx;
    spec.ny = problem.grid.ny;
    return half_space_table(spec, observer);
}

/// Returns how much products may change a coefficient, over zz of half-spaces under an element: a thousandth of the
/// error of the tables of longitudinally uniform bodies. It is zero for given tables, which may be exact.
double negligible(const Bodies& bodies) {
    constexpr double of_error = 1e-3, of_rotated_half_spaces = 1e-3;
    double error = 0;
    for (const Body* body : {&bodies.upper, &bodies.lower}) {
        if (body->section() == nullptr) continue;
        const Ics& ics = *body->computed();
        const double own = ics.source == IcSource::fem && ics.accuracy > 0 ? ics.accuracy : of_rotated_half_spaces;
        error = error == 0 ? own : std::min(error, own);
    }
    return of_error * error;
}

StripTable extended(const StripTable& table, const IcTable& near) {
    StripTable result(near.nx, table.strips);
    const int last = table.nx - 1;
    for (int a = 0; a < 9; ++a) {
        const Axis i{a / 3}, j{a % 3};
        for (int I = 0; I < table.strips; ++I)
            for (int J = 0; J < table.strips; ++J) {
                std::copy_n(&table.values[table.index(i, j, I, J, 0)], table.nx,
                            &result.values[result.index(i, j, I, J, 0)]);
                const double difference = table(i, j, I, J, last) - near.at(i, j, last, I - J);
                for (int k = table.nx; k < near.nx; ++k) result(i, j, I, J, k) = near.at(i, j, k, I - J) + difference;
            }
    }
    return result;
}

/// Computes the table at the offsets k + step, i = x and y: that of half-spaces plus the interpolated difference to
/// them.
class Shifted {
   public:
    Shifted(const StripTable& table, const IcTable& near, const ShiftedTable& near_ahead, const StepAlongStrips& step)
        : table_(table), near_(near), near_ahead_(near_ahead), step_(step), weights_(cubic_weights(step.fraction)) {}

    double operator()(Axis i, Axis j, int I, int J, int k) const {
        double value = near_ahead_(i, j, k, I - J);
        for (int node = -1; node < 3; ++node)
            value += weights_[static_cast<std::size_t>(node + 1)] * difference(i, j, I, J, k + step_.whole + node);
        return value;
    }

   private:
    double difference(Axis i, Axis j, int I, int J, int k) const {
        const int last = std::min(table_.nx, near_.nx) - 1, within = std::clamp(k, -last, last);
        return table_.at(i, j, I, J, within) - near_.at(i, j, within, I - J);
    }

    const StripTable& table_;
    const IcTable& near_;
    const ShiftedTable& near_ahead_;
    const StepAlongStrips step_;
    const std::array<double, 4> weights_;
};

/// Sets the coefficients of loads along x and y and displacements along z, which steps do not need, by reciprocity,
/// because operators use means of both.
void complete(StripTable& table) {
    for (const Axis j : {Axis::x, Axis::y}) {
        const double sign = parity(j, Axis::z).along_x;
        for (int I = 0; I < table.strips; ++I)
            for (int J = 0; J < table.strips; ++J)
                for (int k = 0; k < table.nx; ++k) table(Axis::z, j, J, I, k) = sign * table(j, Axis::z, I, J, k);
    }
}

/// Returns A(k) minus the mean of A' = A(k + step) at both signs of k, by parity, and half of their difference.
StripIncrement change_of(const StripTable& table, const Shifted& ahead, int nx, double left_out,
                         const Observer& observer) {
    StripTable natural(nx, table.strips), opposite(nx, table.strips);
    for (const Axis i : {Axis::x, Axis::y})
        for (const Axis j : {Axis::x, Axis::y, Axis::z}) {
            const int sign = parity(i, j).along_x;
            for (int I = 0; I < table.strips; ++I) {
                observer.throw_if_cancelled();
                for (int J = 0; J < table.strips; ++J)
                    for (int k = 0; k < nx; ++k) {
                        const double front = ahead(i, j, I, J, k), back = sign * ahead(i, j, I, J, -k);
                        natural(i, j, I, J, k) = table(i, j, I, J, k) - 0.5 * (front + back);
                        opposite(i, j, I, J, k) = 0.5 * (back - front);
                    }
            }
        }
    complete(natural);
    complete(opposite);
    return {std::make_shared<const StripParts>(std::move(natural), nx, OffsetParity::natural, left_out),
            std::make_shared<const StripParts>(std::move(opposite), nx, OffsetParity::opposite, left_out)};
}

}  // namespace

ContactInfluence strip_influence(const ContactProblem& problem, StripTable pair, const Observer& observer) {
    const Grid& grid = problem.grid;
    if (pair.strips != grid.ny || pair.nx < grid.nx)
        throw InvalidArgument("grid", "has " + std::to_string(grid.ny) + " rows of " + std::to_string(grid.nx) +
                                          " elements; the table contains " + std::to_string(pair.strips) +
                                          " strips and " + std::to_string(pair.nx) + " offsets along x");
    const StepAlongStrips step = step_along_strips(problem);
    const int offsets = grid.nx + step.reach();
    const IcTable near = pair_of(half_space(problem, problem.bodies.upper, offsets, observer),
                                 half_space(problem, problem.bodies.lower, offsets, observer));
    if (pair.nx < offsets) pair = extended(pair, near);
    const double left_out = negligible(problem.bodies) * near(Axis::z, Axis::z, 0, 0);
    const auto coefficients = std::make_shared<const TableCoefficients>(std::move(pair));
    const auto parts = std::make_shared<const StripParts>(coefficients, grid.nx, OffsetParity::natural, left_out);
    ContactInfluence influence;
    influence.current = std::make_shared<const StripOperator>(
        parts, parts->extent(), std::make_shared<const ConvolutionOperator>(near, grid.nx, grid.ny));
    const auto [x, y] = step_of(problem);
    if (x == 0) return influence;
    const ShiftedTable near_ahead = shifted_half_spaces({problem.bodies.materials()}, grid, x, 0, observer);
    auto near_step = std::make_shared<const ShiftedOperator>(change_over_step(near, near_ahead));
    if (step.fraction == 0)
        influence.increment =
            std::make_shared<const StripStep>(parts, parts->extent(), step.whole, std::move(near_step));
    else
        influence.increment = std::make_shared<const StripStep>(
            change_of(coefficients->table(), Shifted(coefficients->table(), near, near_ahead, step), grid.nx,
                      left_out * std::min(1.0, std::abs(x) / grid.dx), observer),
            parts->extent(), parts->coupled(), std::move(near_step));
    return influence;
}

}  // namespace contactd
