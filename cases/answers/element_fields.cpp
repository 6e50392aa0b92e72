#include "element_fields.hpp"

#include <cstddef>
#include <variant>

#include "closed_forms/undeformed_distance.hpp"
#include "contact/rolling/rolling.hpp"

namespace contactd::cases {
namespace {

/// Returns the rigid slip per distance rolled.
RigidSlip relative_slip(const Grid& grid, const Rolling& rolling, double dq) {
    RigidSlip slip = rigid_slip(grid, rolling, dq);
    for (auto* component : {&slip.x, &slip.y})
        for (double& s : *component) s /= dq;
    return slip;
}

/// Returns the motion without creepages found for a prescribed force, which CONTACT excludes from the rigid slip. The
/// contribution of spin about its centre remains.
Motion without_found(const Solved& solved) {
    Motion motion = *solved.solution.motion;
    if (auto* rolling = std::get_if<Rolling>(&motion)) {
        if (rolling->force.Fx) rolling->xi = rolling->phi * solved.spin_y;
        if (rolling->force.Fy) rolling->eta = -rolling->phi * solved.spin_x;
        return motion;
    }
    auto& shift = std::get<Shift>(motion);
    if (shift.force.Fx) shift.rigid_shift.x = shift.rotation * solved.spin_y;
    if (shift.force.Fy) shift.rigid_shift.y = -shift.rotation * solved.spin_x;
    return motion;
}

}  // namespace

RigidSlip rigid_slip_of(const Solved& solved) {
    const Grid& grid = solved.problem.grid;
    if (!solved.solution.motion) return {};
    const Motion motion = without_found(solved);
    const auto* rolling = std::get_if<Rolling>(&motion);
    RigidSlip slip = rolling ? relative_slip(grid, *rolling, step_length(*rolling, grid))
                             : rigid_slip(grid, std::get<Shift>(motion));
    const RigidSlip& extra = solved.problem.rigid_slip;
    for (std::size_t i = 0; i < extra.x.size(); ++i) {
        slip.x[i] += extra.x[i];
        slip.y[i] += extra.y[i];
    }
    return slip;
}

std::vector<double> friction_of(const Solved& solved) {
    const ContactProblem& problem = solved.problem;
    if (!problem.friction) return {};
    if (!solved.solution.friction_coefficient.empty()) return solved.solution.friction_coefficient;
    const FrictionLaw& law = *problem.friction;
    const auto columns = static_cast<std::size_t>(problem.grid.nx);
    std::vector<double> mu;
    for (std::size_t i = 0; i < problem.grid.size(); ++i) {
        mu.push_back(law.mu_of(i));
        if (!law.follows_temperature()) continue;
        const TemperatureFriction& heated = law.temperature ? *law.temperature : law.temperature_of_rows[i / columns];
        mu[i] = friction_coefficient(heated, mu[i], solved.solution.upper_temperature[i]);
    }
    return mu;
}

std::vector<double> in_contact(std::vector<double> displacement, const ContactSolution& solution) {
    for (std::size_t i = 0; i < displacement.size(); ++i)
        if (solution.element_division[i] == ElementState::exterior) displacement[i] = 0;
    return displacement;
}

std::vector<double> distance_of(const Solved& solved) {
    return undeformed_distance(solved.problem);
}

}  // namespace contactd::cases
