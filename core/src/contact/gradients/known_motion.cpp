#include "known_motion.hpp"

#include "contact/support/entering_particles.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

void add_to(Values& to, const Values& from, double factor) {
    if (to.empty()) to.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) to[i] += factor * from[i];
}

// Particles that enter during a step move with the body for a part of it only.
Field of_rigid_slip(const ContactProblem& problem, const ContactSolution& solution, Field slip) {
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (rolling == nullptr) return slip;
    const double dq = step_length(*rolling, problem.grid);
    std::vector<double> part;
    if (!rolling->steady()) part = entering_particles(problem.grid, solution.pressure, step_of(problem)).part;
    for (Values* values : {&slip.x, &slip.y})
        for (std::size_t i = 0; i < values->size(); ++i) (*values)[i] *= dq * (part.empty() ? 1 : part[i]);
    return slip;
}

void sum_motion(const ContactProblem& problem, GradientOfKnownMotion& gradient) {
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    const auto [step_x, step_y] = step_of(problem);
    const double ahead = rolling != nullptr ? rolling->spin_offset : 0;
    const Grid& grid = problem.grid;
    const Field& v = gradient.rigid_slip;
    std::size_t i = 0;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix, ++i) {
            gradient.along_x += v.x[i];
            gradient.along_y += v.y[i];
            gradient.about_z += (grid.x(ix) + ahead * step_x) * v.y[i] - (grid.y(iy) + ahead * step_y) * v.x[i];
        }
}

}  // namespace

void GradientOfKnownMotion::add(const GradientOfKnownMotion& other, double factor) {
    approach += factor * other.approach;
    along_x += factor * other.along_x;
    along_y += factor * other.along_y;
    about_z += factor * other.about_z;
    add_to(gap, other.gap, factor);
    add_to(mu, other.mu, factor);
    add_to(rigid_slip.x, other.rigid_slip.x, factor);
    add_to(rigid_slip.y, other.rigid_slip.y, factor);
    upper.G += factor * other.upper.G;
    upper.nu += factor * other.upper.nu;
    lower.G += factor * other.lower.G;
    lower.nu += factor * other.lower.nu;
    add_to(previous.pressure, other.previous.pressure, factor);
    add_to(previous.traction_x, other.previous.traction_x, factor);
    add_to(previous.traction_y, other.previous.traction_y, factor);
}

GradientOfKnownMotion gradient_of(const ContactProblem& problem, const ContactSolution& solution,
                                  const OutputWeights& weights, const Adjoint& adjoint) {
    GradientOfKnownMotion gradient;
    for (const double l : adjoint.normal) {
        gradient.approach += l;
        gradient.gap.push_back(-l);
    }
    if (problem.friction) {
        gradient.mu = adjoint.bound;
        for (std::size_t i = 0; i < gradient.mu.size(); ++i) gradient.mu[i] *= solution.pressure[i];
        gradient.rigid_slip = of_rigid_slip(problem, solution, adjoint.slip);
        sum_motion(problem, gradient);
    }
    gradient.approach += weights.approach;
    gradient.along_x += weights.along_x;
    gradient.along_y += weights.along_y;
    return gradient;
}

}  // namespace contactd
