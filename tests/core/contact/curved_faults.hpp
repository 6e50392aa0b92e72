// Checks the equations of contacts on curved strips independently of the solvers, with dense sums.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "contact_cases.hpp"
#include "contactd/strip_table.hpp"

namespace contactd::test {

/// Returns u_i due to all three components of tractions, element by element, `ahead` elements ahead of them.
inline Values dense_displacement(const StripTable& table, Axis i, const SurfaceState& state, int nx, int ahead = 0) {
    const std::size_t n = state.pressure.size();
    Values u(n);
    for (std::size_t to = 0; to < n; ++to)
        for (std::size_t from = 0; from < n; ++from) {
            const int at = static_cast<int>(to), of = static_cast<int>(from);
            const int I = at / nx, J = of / nx, k = at % nx - of % nx + ahead;
            u[to] += table.at(i, Axis::z, I, J, k) * state.pressure[from] +
                     table.at(i, Axis::x, I, J, k) * state.traction_x[from] +
                     table.at(i, Axis::y, I, J, k) * state.traction_y[from];
        }
    return u;
}

/// Returns the error of a displacement (mm) if coefficients differ by this much from those of the check (mm^3/N).
inline double displacement_left(const ContactSolution& solution, double coefficient) {
    double sum = 0;
    for (std::size_t i = 0; i < solution.pressure.size(); ++i)
        sum += solution.pressure[i] + std::abs(solution.traction_x[i]) + std::abs(solution.traction_y[i]);
    return coefficient * sum;
}

inline SurfaceState state_of(const ContactSolution& solution) {
    return {solution.pressure, solution.traction_x, solution.traction_y};
}

/// Returns the violations of p >= 0, gap >= 0, one of them zero, and the force; empty if there are none. `left_out` is
/// the change of a coefficient that products may have (mm^3/N).
inline std::string curved_normal_faults(const ContactProblem& problem, const StripTable& table,
                                        const ContactSolution& solution, double accuracy, double left_out = 0) {
    const Grid& grid = problem.grid;
    const Values uz = dense_displacement(table, Axis::z, state_of(solution), grid.nx);
    const auto& h = std::get<Values>(*problem.gap);
    const double unit =
        accuracy * std::max(largest(uz), std::abs(solution.approach)) + displacement_left(solution, left_out);
    const auto fault = [](std::size_t i, const char* what, double value) {
        return "element " + std::to_string(i) + ": " + what + ", " + std::to_string(value);
    };
    double force = 0;
    for (std::size_t i = 0; i < h.size(); ++i) {
        const double angle = problem.columns->frames[i / static_cast<std::size_t>(grid.nx)].angle;
        const double cosine = std::cos(angle - problem.columns->direction), p = solution.pressure[i];
        const double gap = h[i] + uz[i] - solution.approach * cosine;
        if (!(p >= 0)) return fault(i, "negative pressure", p);
        if (p > 0 && !(std::abs(gap) <= unit)) return fault(i, "contact with a gap over the tolerance", gap / unit);
        if (!(gap >= -unit)) return fault(i, "overlap over the tolerance", gap / unit);
        force += p * cosine * grid.element_area();
    }
    if (!(std::abs(force - solution.forces.Fn) <= 1e-10 * force)) return "Fn is not the sum of the pressures";
    if (problem.Fn && !(std::abs(force - *problem.Fn) <= 1e-8 * *problem.Fn)) return "the normal force is missed";
    return {};
}

/// Returns the slip of the elements (mm) in a shift, or in a rolling step by whole elements, for a rigid motion.
struct DenseSlip {
    Values x, y, rigid_x, rigid_y;
};
inline DenseSlip dense_slip(const ContactProblem& problem, const StripTable& table, const ContactSolution& solution) {
    const Grid& grid = problem.grid;
    const auto& strips = *problem.columns;
    const auto* rolling = std::get_if<Rolling>(&*solution.motion);
    const auto* shift = std::get_if<Shift>(&*solution.motion);
    const double dq = rolling ? step_length(*rolling, grid) : 1;
    const double along_x = rolling ? rolling->xi : shift->rigid_shift.x;
    const double across = rolling ? rolling->eta : shift->rigid_shift.y;
    const double turn = rolling ? rolling->phi : shift->rotation;
    const double ahead = rolling ? rolling->spin_offset * dq * std::cos(rolling->chi) : 0;
    const int steps = rolling ? static_cast<int>(std::lround(dq * std::cos(rolling->chi) / grid.dx)) : 0;
    const SurfaceState now = state_of(solution);
    DenseSlip slip{
        dense_displacement(table, Axis::x, now, grid.nx), dense_displacement(table, Axis::y, now, grid.nx), {}, {}};
    // Returns the state one step ago; before the first step of a transient there is none.
    const SurfaceState& before = rolling && rolling->steady() ? now : problem.previous;
    if (!before.pressure.empty()) {
        const Values bx = dense_displacement(table, Axis::x, before, grid.nx, steps);
        const Values by = dense_displacement(table, Axis::y, before, grid.nx, steps);
        for (std::size_t i = 0; i < bx.size(); ++i) {
            slip.x[i] -= bx[i];
            slip.y[i] -= by[i];
        }
    }
    // Returns v + turn a x r, with a the direction of approach, along x and along each strip's tangent.
    const double ay = std::sin(strips.direction), az = std::cos(strips.direction);
    for (int iy = 0; iy < grid.ny; ++iy) {
        const StripFrame& frame = strips.frames[static_cast<std::size_t>(iy)];
        const double ry = frame.y - strips.origin.y, rz = frame.z - strips.origin.z;
        const double sy = std::cos(frame.angle), sz = -std::sin(frame.angle);
        for (int ix = 0; ix < grid.nx; ++ix) {
            const double rx = grid.x(ix) + ahead;
            const double vx = along_x + turn * (ay * rz - az * ry);
            const double vy = across * az + turn * az * rx, vz = -across * ay - turn * ay * rx;
            slip.rigid_x.push_back(dq * vx);
            slip.rigid_y.push_back(dq * (vy * sy + vz * sz));
        }
    }
    slip.x = sum(std::move(slip.x), slip.rigid_x);
    slip.y = sum(std::move(slip.y), slip.rigid_y);
    return slip;
}

/// Returns violations of Coulomb's law in contact; empty if there are none. `accuracy` is the error of slip over the
/// largest rigid slip. `left_out` is the change of a coefficient that products may have (mm^3/N).
inline std::string curved_friction_faults(const ContactProblem& problem, const StripTable& table,
                                          const ContactSolution& solution, double accuracy, double left_out = 0) {
    const DenseSlip slip = dense_slip(problem, table, solution);
    // The factor is two, because slip is the difference of two displacements.
    const double unit =
        accuracy * std::max(largest(slip.rigid_x), largest(slip.rigid_y)) + 2 * displacement_left(solution, left_out);
    for (std::size_t i = 0; i < solution.pressure.size(); ++i) {
        const double px = solution.traction_x[i], py = solution.traction_y[i], p = std::hypot(px, py);
        const double g = problem.friction->mu[0] * solution.pressure[i], s = std::hypot(slip.x[i], slip.y[i]);
        const auto fault = [&](const char* what) {
            return "element " + std::to_string(i) + ": " + what + ", slip over the tolerance " +
                   std::to_string(s / unit);
        };
        if (!(p <= g * (1 + 1e-8))) return fault("the traction exceeds its bound");
        if (solution.element_division[i] == ElementState::adhesion && !(s <= unit)) return fault("adhesion slips");
        if (solution.element_division[i] != ElementState::slip) continue;
        if (!(std::abs(p - g) <= 1e-8 * g)) return fault("slip below the bound");
        if (g == 0) continue;
        if (!(std::abs(slip.x[i] * py - slip.y[i] * px) / g <= unit)) return fault("slip across the traction");
        if (!((slip.x[i] * px + slip.y[i] * py) / g <= unit)) return fault("slip along the traction");
    }
    return {};
}

}  // namespace contactd::test
