#include "uniform_strips.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/strip_frames.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

using Frames = std::vector<StripFrame>;

constexpr double rounding = 1e-6;    // rounding of angles, and of lengths over dy
constexpr double largest_lag = 0.3;  // (rad) between bodies that lie along each other

Frames frames_of(const Body& body, const Grid& grid, const std::string& name) {
    return strip_frames(*body.section(), grid.ny, grid.dy, name + ".ics.section");
}

/// Returns the rotation of strip i relative to the first one.
double turn(const Frames& frames, std::size_t i) {
    return frames[i].angle - frames.front().angle;
}

void check_flat(const Frames& frames, const std::string& name) {
    for (std::size_t i = 0; i < frames.size(); ++i)
        if (std::abs(turn(frames, i)) > rounding)
            throw InvalidArgument("columns", "are missing, but the section of " + name + " is curved: strip " +
                                                 std::to_string(i) + " is rotated by " + short_text(turn(frames, i)) +
                                                 " rad from the first one; give the frames that ic.get returns");
}

void check_same(const Frames& stated, const Frames& of_section, double dy) {
    for (std::size_t i = 1; i < stated.size(); ++i) {
        const auto step = [i](const Frames& frames) {
            return std::hypot(frames[i].y - frames[i - 1].y, frames[i].z - frames[i - 1].z);
        };
        if (std::abs(turn(stated, i) - turn(of_section, i)) <= rounding &&
            std::abs(step(stated) - step(of_section)) <= rounding * dy)
            continue;
        throw InvalidArgument("columns.frames[" + std::to_string(i) + "]",
                              "is rotated by " + short_text(turn(stated, i)) +
                                  " rad from the first one, but the section of bodies.lower by " +
                                  short_text(turn(of_section, i)) +
                                  ", or its strips are at other distances; give the frames that ic.get returns for it");
    }
}

/// The upper body's strips are in reverse order.
void check_along(const Frames& stated, Frames of_upper) {
    std::reverse(of_upper.begin(), of_upper.end());
    for (std::size_t i = 0; i < stated.size(); ++i)
        if (std::abs(turn(stated, i) - turn(of_upper, i)) > largest_lag)
            throw InvalidArgument("columns.frames[" + std::to_string(i) + "]",
                                  "is rotated by " + short_text(turn(stated, i)) +
                                      " rad from the first one, but the opposite strip of bodies.upper by " +
                                      short_text(turn(of_upper, i)) + "; both must be parallel");
}

}  // namespace

void check_strips_of_uniform(const ContactProblem& problem) {
    if (!problem.bodies.any_uniform()) return;
    const auto& [upper, lower, pair] = problem.bodies;
    if (lower.section() != nullptr) {
        const Frames frames = frames_of(lower, problem.grid, "bodies.lower");
        if (problem.columns)
            check_same(problem.columns->frames, frames, problem.grid.dy);
        else
            check_flat(frames, "bodies.lower");
    }
    if (upper.section() == nullptr) return;
    const Frames frames = frames_of(upper, problem.grid, "bodies.upper");
    if (problem.columns)
        check_along(problem.columns->frames, frames);
    else
        check_flat(frames, "bodies.upper");
}

}  // namespace contactd
