// Contacts on columns that are curved along y.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "bodies/column_influence.hpp"
#include "curved_faults.hpp"
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

inline void check_normal_contact(const ContactProblem& problem, const ColumnTable& table,
                                 const ContactSolution& solution, double accuracy) {
    REQUIRE(curved_normal_faults(problem, table, solution, accuracy) == "");
}

/// Of elements in contact; `accuracy` of slip.
inline void check_friction(const ContactProblem& problem, const ColumnTable& table, const ContactSolution& solution,
                           double accuracy) {
    REQUIRE(curved_friction_faults(problem, table, solution, accuracy) == "");
}

inline ContactSolution solve_columns(const ContactProblem& problem, const ColumnTable& table) {
    Observer observer;
    return solve_contact(problem, column_influence(problem, table), observer);
}

}  // namespace contactd::test
