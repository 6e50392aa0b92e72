#include "derivative_table.hpp"

namespace contactd {
namespace {

using Table = DerivativeTable;

// Exchanges Fn as an answer and the approach as an input.
void exchange(DerivativeTable& table) {
    auto& values = table.values;
    const double stiffness = values[Table::Fn][Table::approach];
    auto& of_approach = values[Table::Fn];
    for (int column = 0; column < Table::columns; ++column)
        of_approach[column] = column == Table::approach ? 1 / stiffness : -of_approach[column] / stiffness;
    for (int row = Table::Fx; row < Table::rows; ++row) {
        const double by_approach = values[row][Table::approach];
        for (int column = 0; column < Table::columns; ++column) {
            if (column == Table::approach)
                values[row][column] = by_approach * of_approach[column];
            else
                values[row][column] += by_approach * of_approach[column];
        }
    }
}

DerivativesOfAnswer row_of(const DerivativeTable& table, int row, const ContactProblem& problem) {
    const auto& values = table.values[row];
    DerivativesOfAnswer result;
    (problem.Fn ? result.Fn : result.approach) = values[Table::approach];
    if (!problem.friction) return result;
    if (std::holds_alternative<Rolling>(problem.motion)) {
        result.xi = values[Table::along_x];
        result.eta = values[Table::along_y];
        if (table.has_rotation) result.phi = values[Table::about_z];
    } else {
        result.rigid_shift = DerivativesByShift{values[Table::along_x], values[Table::along_y]};
        if (table.has_rotation) result.rotation = values[Table::about_z];
    }
    if (table.has_mu) result.mu = values[Table::mu];
    return result;
}

}  // namespace

Derivatives named(const DerivativeTable& table, const ContactProblem& problem) {
    DerivativeTable by_inputs = table;
    if (problem.Fn) exchange(by_inputs);
    Derivatives result;
    (problem.Fn ? result.approach : result.Fn) = row_of(by_inputs, Table::Fn, problem);
    if (!problem.friction) return result;
    result.Fx = row_of(by_inputs, Table::Fx, problem);
    result.Fy = row_of(by_inputs, Table::Fy, problem);
    result.Mz = row_of(by_inputs, Table::Mz, problem);
    return result;
}

}  // namespace contactd
