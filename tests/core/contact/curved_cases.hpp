// Creates contacts on strips that are curved along y.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "bodies/strip_influence.hpp"
#include "curved_faults.hpp"
#include "influence/rotated/rotated_half_space.hpp"

namespace contactd::test {

/// Returns strips of arc length ds on a circle of this radius about `centre`, positive convex, negative hollow,
/// numbered along the tangent. The normal of the middle strip has the angle `middle`.
inline std::vector<StripFrame> arc_frames(int strips, double ds, double radius, double middle = 0,
                                          SectionPoint centre = {}) {
    std::vector<StripFrame> frames;
    for (int strip = 0; strip < strips; ++strip) {
        const double angle = middle + (strip - 0.5 * (strips - 1)) * ds / radius;
        frames.push_back({centre.y + radius * std::sin(angle), centre.z + radius * std::cos(angle), angle});
    }
    return frames;
}

/// Returns the frames of a plane through `origin` whose normal has this angle.
inline std::vector<StripFrame> flat_frames(const Grid& grid, double angle, SectionPoint origin = {}) {
    std::vector<StripFrame> frames;
    for (int iy = 0; iy < grid.ny; ++iy)
        frames.push_back({origin.y + grid.y(iy) * std::cos(angle), origin.z - grid.y(iy) * std::sin(angle), angle});
    return frames;
}

/// Both bodies rotated half-spaces on the frames of the problem, made reciprocal.
inline StripTable rotated_pair(const ContactProblem& problem, int more_offsets = 1) {
    const Grid& grid = problem.grid;
    // The upper body's own frames, in its order of travel: it is rotated by pi about x, and so are they.
    std::vector<StripFrame> opposite(problem.columns->frames.rbegin(), problem.columns->frames.rend());
    for (StripFrame& frame : opposite) frame = {-frame.y, -frame.z, frame.angle};
    const auto table = [&](const std::vector<StripFrame>& frames, const Material& material) {
        const int nx = grid.nx + more_offsets;
        if (material.is_rigid()) return StripTable(nx, grid.ny);
        return symmetrised(rotated_half_space({frames, grid.dy, 0, grid.dx, nx}, material, LoadShape::constant));
    };
    return pair_of(table(opposite, problem.bodies.upper.material),
                   table(problem.columns->frames, problem.bodies.lower.material));
}

inline void check_normal_contact(const ContactProblem& problem, const StripTable& table,
                                 const ContactSolution& solution, double accuracy) {
    REQUIRE(curved_normal_faults(problem, table, solution, accuracy) == "");
}

/// Checks elements in contact; `accuracy` applies to slip.
inline void check_friction(const ContactProblem& problem, const StripTable& table, const ContactSolution& solution,
                           double accuracy) {
    REQUIRE(curved_friction_faults(problem, table, solution, accuracy) == "");
}

inline ContactSolution solve_strips(const ContactProblem& problem, const StripTable& table) {
    Observer observer;
    return solve_contact(problem, strip_influence(problem, table), observer);
}

}  // namespace contactd::test
