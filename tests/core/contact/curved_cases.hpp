// Contacts on columns that are curved along y, and their equations checked with dense sums.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "bodies/column_influence.hpp"
#include "contact_cases.hpp"
#include "influence/rotated/rotated_half_space.hpp"

namespace contactd::test {

/// Columns of arc length ds on a circle of this radius about `centre`, positive convex, negative hollow, numbered along
/// the tangent; the middle one's normal has the angle `middle`.
inline std::vector<ColumnFrame> arc_frames(int columns, double ds, double radius, double middle = 0,
                                           SectionPoint centre = {}) {
    std::vector<ColumnFrame> frames;
    for (int column = 0; column < columns; ++column) {
        const double angle = middle + (column - 0.5 * (columns - 1)) * ds / radius;
        frames.push_back({centre.y + radius * std::sin(angle), centre.z + radius * std::cos(angle), angle});
    }
    return frames;
}

/// Of a plane through `origin` whose normal has this angle.
inline std::vector<ColumnFrame> flat_frames(const Grid& grid, double angle, SectionPoint origin = {}) {
    std::vector<ColumnFrame> frames;
    for (int iy = 0; iy < grid.ny; ++iy)
        frames.push_back({origin.y + grid.y(iy) * std::cos(angle), origin.z - grid.y(iy) * std::sin(angle), angle});
    return frames;
}

/// Both bodies turned half-spaces on the frames of the problem, made reciprocal.
inline ColumnTable turned_pair(const ContactProblem& problem, int more_offsets = 1) {
    const Grid& grid = problem.grid;
    // The upper body's own frames, in its order of travel: it is turned by pi about x, and so are they.
    std::vector<ColumnFrame> opposite(problem.columns->frames.rbegin(), problem.columns->frames.rend());
    for (ColumnFrame& frame : opposite) frame = {-frame.y, -frame.z, frame.angle};
    const auto table = [&](const std::vector<ColumnFrame>& frames, const Material& material) {
        const int nx = grid.nx + more_offsets;
        if (material.is_rigid()) return ColumnTable(nx, grid.ny);
        return symmetrised(rotated_half_space({frames, grid.dy, 0, grid.dx, nx}, material, LoadShape::constant));
    };
    return pair_of(table(opposite, problem.bodies.upper.material),
                   table(problem.columns->frames, problem.bodies.lower.material));
}

/// u_i of all three components of tractions, element by element, `ahead` elements ahead of them.
inline Values dense_displacement(const ColumnTable& table, Axis i, const ContactSolution& solution, int nx,
                                 int ahead = 0) {
    const std::size_t n = solution.pressure.size();
    Values u(n);
    for (std::size_t to = 0; to < n; ++to)
        for (std::size_t from = 0; from < n; ++from) {
            const int at = static_cast<int>(to), of = static_cast<int>(from);
            const int I = at / nx, J = of / nx, k = at % nx - of % nx + ahead;
            u[to] += table.at(i, Axis::z, I, J, k) * solution.pressure[from] +
                     table.at(i, Axis::x, I, J, k) * solution.traction_x[from] +
                     table.at(i, Axis::y, I, J, k) * solution.traction_y[from];
        }
    return u;
}

/// p >= 0, gap >= 0, and one of them zero; the force where it is prescribed.
inline void check_normal_contact(const ContactProblem& problem, const ColumnTable& table,
                                 const ContactSolution& solution, double accuracy) {
    const Grid& grid = problem.grid;
    const Values uz = dense_displacement(table, Axis::z, solution, grid.nx);
    const auto& h = std::get<Values>(*problem.gap);
    const double unit = accuracy * std::max(largest(uz), std::abs(solution.approach));
    double force = 0;
    for (std::size_t i = 0; i < h.size(); ++i) {
        const double angle = problem.columns->frames[i / static_cast<std::size_t>(grid.nx)].angle;
        const double cosine = std::cos(angle - problem.columns->direction);
        const double gap = h[i] + uz[i] - solution.approach * cosine;
        CAPTURE(i, gap, unit, solution.pressure[i]);
        REQUIRE(solution.pressure[i] >= 0);
        if (solution.pressure[i] > 0)
            REQUIRE(std::abs(gap) <= unit);
        else
            REQUIRE(gap >= -unit);
        force += solution.pressure[i] * cosine * grid.element_area();
    }
    REQUIRE(std::abs(force - solution.forces.Fn) <= 1e-10 * force);
    if (problem.Fn) REQUIRE(std::abs(force - *problem.Fn) <= 1e-8 * *problem.Fn);
}

/// Slip of the elements (mm): of a shift, or of steady rolling by whole elements; by the motion of a rigid body.
struct DenseSlip {
    Values x, y, rigid_x, rigid_y;
};
inline DenseSlip dense_slip(const ContactProblem& problem, const ColumnTable& table, const ContactSolution& solution) {
    const Grid& grid = problem.grid;
    const auto& columns = *problem.columns;
    const auto* rolling = std::get_if<Rolling>(&*solution.motion);
    const auto* shift = std::get_if<Shift>(&*solution.motion);
    const double dq = rolling ? step_length(*rolling, grid) : 1;
    const double along_x = rolling ? rolling->xi : shift->rigid_shift.x;
    const double across = rolling ? rolling->eta : shift->rigid_shift.y;
    const double turn = rolling ? rolling->phi : shift->rotation;
    const double ahead = rolling ? rolling->spin_offset * dq * std::cos(rolling->chi) : 0;
    const int steps = rolling ? static_cast<int>(std::lround(dq * std::cos(rolling->chi) / grid.dx)) : 0;
    DenseSlip slip{dense_displacement(table, Axis::x, solution, grid.nx),
                   dense_displacement(table, Axis::y, solution, grid.nx),
                   {},
                   {}};
    if (rolling) {
        const Values bx = dense_displacement(table, Axis::x, solution, grid.nx, steps);
        const Values by = dense_displacement(table, Axis::y, solution, grid.nx, steps);
        for (std::size_t i = 0; i < bx.size(); ++i) {
            slip.x[i] -= bx[i];
            slip.y[i] -= by[i];
        }
    }
    // v + turn a x r, with a the direction of approach, along x and along each column's tangent.
    const double ay = std::sin(columns.direction), az = std::cos(columns.direction);
    for (int iy = 0; iy < grid.ny; ++iy) {
        const ColumnFrame& frame = columns.frames[static_cast<std::size_t>(iy)];
        const double ry = frame.y - columns.origin.y, rz = frame.z - columns.origin.z;
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

/// Coulomb's law of elements in contact. `accuracy`: of slip, relative to the largest rigid slip.
inline void check_friction(const ContactProblem& problem, const ColumnTable& table, const ContactSolution& solution,
                           double accuracy) {
    const DenseSlip slip = dense_slip(problem, table, solution);
    const double unit = accuracy * std::max(largest(slip.rigid_x), largest(slip.rigid_y));
    for (std::size_t i = 0; i < solution.pressure.size(); ++i) {
        const double px = solution.traction_x[i], py = solution.traction_y[i], p = std::hypot(px, py);
        const double g = problem.friction->mu[0] * solution.pressure[i];
        CAPTURE(i, p, g, slip.x[i], slip.y[i], unit);
        REQUIRE(p <= g * (1 + 1e-8));
        if (solution.element_division[i] == ElementState::adhesion) REQUIRE(std::hypot(slip.x[i], slip.y[i]) <= unit);
        if (solution.element_division[i] == ElementState::slip) {
            REQUIRE(std::abs(p - g) <= 1e-8 * g);
            REQUIRE(std::abs(slip.x[i] * py - slip.y[i] * px) / g <= unit);
            REQUIRE((slip.x[i] * px + slip.y[i] * py) / g <= unit);
        }
    }
}

inline ContactSolution solve_columns(const ContactProblem& problem, const ColumnTable& table) {
    Observer observer;
    return solve_contact(problem, column_influence(problem, table), observer);
}

}  // namespace contactd::test
