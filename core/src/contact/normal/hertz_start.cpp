#include "hertz_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "closed_forms/elliptic_contact.hpp"
#include "closed_forms/hertz.hpp"
#include "closed_forms/undeformed_distance.hpp"

namespace contactd {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Ellipse {
    SemiAxes axes;  // one may be infinite
    double pmax = 0;
};

// Returns the contact of a cylinder over the length of the grid. The approach of line contacts depends on the far
// field.
Ellipse strip(const ContactProblem& problem, const Paraboloid& gap) {
    if (!problem.Fn) return {};
    const Grid& grid = problem.grid;
    const bool along_y = gap.Ry == infinity;
    const double length = along_y ? grid.ny * grid.dy : grid.nx * grid.dx;
    const double force = *problem.Fn / length, R = std::min(gap.Rx, gap.Ry);
    // These are Johnson's (4.43) and (4.45), with the force over the length.
    const double a = std::sqrt(4 * force * R * problem.bodies.materials().normal_compliance() / std::numbers::pi);
    return {along_y ? SemiAxes{a, infinity} : SemiAxes{infinity, a}, 2 * force / (std::numbers::pi * a)};
}

// Returns an empty ellipse if Hertz's theory does not apply.
Ellipse ellipse(const ContactProblem& problem, const Paraboloid& gap) {
    const double load = problem.Fn ? *problem.Fn : *problem.approach;
    if (!(gap.Rx > 0 && gap.Ry > 0 && load > 0) || std::min(gap.Rx, gap.Ry) == infinity) return {};
    if (std::max(gap.Rx, gap.Ry) == infinity) return strip(problem, gap);
    const double compliance = problem.bodies.materials().normal_compliance();
    const HertzContact hertz =
        problem.Fn ? hertz_of_force(gap, compliance, load) : hertz_of_approach(gap, compliance, load);
    return {{hertz.a, hertz.b}, hertz.pmax};
}

}  // namespace

std::vector<double> hertz_start(const ContactProblem& problem) {
    if (problem.bodies.pair || problem.bodies.any_layered() || problem.bodies.any_uniform()) return {};
    const auto gap = paraboloid_of(problem);
    if (!gap) return {};
    const auto [axes, pmax] = ellipse(problem, *gap);
    // Any of them may underflow.
    if (!(axes.a > 0 && axes.b > 0 && pmax > 0 && std::isfinite(pmax))) return {};
    std::vector<double> pressure = hertz_pressure(problem.grid, axes, pmax);
    if (std::none_of(pressure.begin(), pressure.end(), [](double p) { return p > 0; })) pressure.clear();
    return pressure;
}

}  // namespace contactd
