#include "unit_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>
#include <variant>

#include "contact/warnings/height_warnings.hpp"
#include "contact/warnings/slow_rolling.hpp"
#include "types/number_text.hpp"
#include "types/units/plausibility.hpp"

namespace contactd {
namespace {

using Sentences = std::vector<std::string>;

/// Warns of rigid slip above 1 in rolling, which is probably a length in mm.
void warn_of_rigid_slip_that_is_no_creepage(const ContactProblem& problem, Sentences& warnings) {
    if (!problem.friction || !std::holds_alternative<Rolling>(problem.motion)) return;
    double largest = 0;
    for (std::size_t i = 0; i < problem.rigid_slip.x.size(); ++i)
        largest = std::max(largest, std::hypot(problem.rigid_slip.x[i], problem.rigid_slip.y[i]));
    if (largest <= 1) return;
    warnings.push_back("friction.rigid_slip is up to " + short_text(largest) +
                       ", so the bodies slip farther than they roll. In rolling, give rigid slip per distance rolled, "
                       "like creepages, not in mm.");
}

constexpr double largest_strain = 0.1;  // shear strain, for linear elasticity

/// Warns of pressures that no elastic body carries, which follow from loads, radii and moduli in different units. Thin,
/// nearly incompressible layers are excluded, because they carry such pressures at small strains.
void warn_of_pressures_beyond_elasticity(const ContactProblem& problem, const ContactSolution& solution,
                                         Sentences& warnings) {
    if (problem.bodies.pair || problem.bodies.any_layered() || !(solution.pmax > 0)) return;
    double softest = std::numeric_limits<double>::infinity();
    for (const Body* body : {&problem.bodies.upper, &problem.bodies.lower})
        if (body->computed() != nullptr && !body->material.is_rigid()) softest = std::min(softest, body->material.G);
    if (!(solution.pmax > largest_strain * softest)) return;
    warnings.push_back("The largest pressure, " + short_text(solution.pmax) +
                       " N/mm^2, is more than a tenth of the shear modulus, " + short_text(softest) +
                       " N/mm^2. Linear elasticity does not hold for such strains. Check the units of forces, lengths "
                       "and moduli.");
}

/// Warns of strengths above a tenth of the shear modulus, where even perfect crystals yield. They are probably in Pa.
void warn_of_strengths_beyond_elasticity(const ContactProblem& problem, Sentences& warnings) {
    double stiffest = 0;
    for (const Body* body : {&problem.bodies.upper, &problem.bodies.lower})
        if (!body->material.is_rigid()) stiffest = std::max(stiffest, body->material.G);
    if (problem.bodies.pair || !(stiffest > 0)) return;
    const auto warn_of = [&](const std::string& field, double strength) {
        if (!std::isfinite(strength) || strength <= largest_strain * stiffest) return;
        warnings.push_back(field + " is " + short_text(strength) + " N/mm^2, more than a tenth of the shear modulus, " +
                           short_text(stiffest) + " N/mm^2. No material is that strong. Give it in N/mm^2, not in Pa.");
    };
    if (problem.friction && problem.friction->layer)
        warn_of("friction.layer.yield_stress", problem.friction->layer->yield_stress);
    if (!problem.fatigue || !problem.fatigue->strength) return;
    warn_of("fatigue.strength.shear_yield", problem.fatigue->strength->shear_yield);
    warn_of("fatigue.strength.tau_e", problem.fatigue->strength->tau_e.value_or(0));
}

void warn_of_friction_in_percent(const ContactProblem& problem, Sentences& warnings) {
    if (!problem.friction || problem.friction->mu.empty()) return;
    const auto warn_of = [&](const char* says, double mu) {
        if (auto sentence = doubt(Quantity::friction_coefficient, says, mu)) warnings.push_back(std::move(*sentence));
    };
    warn_of("friction.mu is up to", *std::ranges::max_element(problem.friction->mu));
    if (problem.friction->kinetic) warn_of("friction.kinetic.mu is up to", problem.friction->kinetic->mu);
}

constexpr double largest_of_vehicles = 0.05;

/// Returns whether a vehicle's contact slides everywhere, and the problem contains nothing that depends on the amount
/// of sliding, such as heat or falling friction. Forces are not prescribed. If the creepages were in percent, the
/// correct ones would leave an adhesion area.
bool slides_as_a_vehicle_never_does(const ContactProblem& problem, const Rolling& rolling,
                                    const ContactSolution& solution) {
    constexpr double of_vehicles = 1e4;  // mm/s
    const FrictionLaw& friction = *problem.friction;
    return rolling.velocity >= of_vehicles && rolling.steady() && rolling.force.empty() && !friction.kinetic &&
           !friction.layer && !problem.temperature && !friction.follows_temperature() &&
           solution.elements.adhesion == 0 && solution.elements.slip > 0;
}

/// Warns of creepages that are too large for rolling, which are probably in percent or in another unit of length.
void warn_of_large_creepages(const ContactProblem& problem, const ContactSolution& solution, Sentences& warnings) {
    constexpr double largest_creepage = 0.5;  // for wheels on rails
    const auto* rolling = problem.friction ? std::get_if<Rolling>(&problem.motion) : nullptr;
    if (rolling == nullptr) return;
    for (const auto& [name, creepage] : {std::pair("xi", rolling->xi), std::pair("eta", rolling->eta)})
        if (std::abs(creepage) > largest_creepage)
            warnings.push_back(std::string("friction.rolling.") + name + " is " + short_text(creepage) +
                               ": the surfaces slide by " + short_text(100 * std::abs(creepage)) +
                               " % of the distance rolled. Give creepages as ratios, not in percent.");
    if (slides_as_a_vehicle_never_does(problem, *rolling, solution))
        for (const auto& [name, creepage] : {std::pair("xi", rolling->xi), std::pair("eta", rolling->eta)})
            if (std::abs(creepage) > largest_of_vehicles && std::abs(creepage) <= largest_creepage)
                warnings.push_back(std::string("friction.rolling.") + name + " is " + short_text(creepage) + ": at " +
                                   short_text(rolling->velocity / 1000) + " m/s the surfaces slide at " +
                                   short_text(std::abs(creepage) * rolling->velocity / 1000) +
                                   " m/s, which wheels do only briefly. Give creepages as ratios, not in percent: "
                                   "0.2 % is 0.002.");
    const double size = std::sqrt(solution.area.contact / std::numbers::pi);
    if (std::abs(rolling->phi) * size > 1)
        warnings.push_back("friction.rolling.phi is " + short_text(rolling->phi) + ": at the contact's radius of " +
                           short_text(size) + " mm the surfaces slide by " + short_text(std::abs(rolling->phi) * size) +
                           " of the distance rolled. Give the spin in 1/mm (rad per mm rolled), not in 1/m.");
}

/// Warns of moduli that match steel only as Young's modulus or in Pa.
void warn_of_moduli(const ContactProblem& problem, Sentences& warnings) {
    if (problem.bodies.pair) return;
    constexpr double pascal = 1e6;  // N/mm^2
    const bool is_in_mm = problem.grid.nx * problem.grid.dx > 1 && problem.grid.ny * problem.grid.dy > 1;
    const auto warn_of = [&](std::string_view name, const Body& body) {
        const auto [G, nu] = std::pair(body.material.G, body.material.nu);
        const bool is_steel = nu >= 0.27 && nu <= 0.31 && !body.material.is_rigid() && body.computed() != nullptr;
        if (!is_steel) return;
        const auto says = [&](double factor) {
            const bool shear = G > 7.4e4 * factor && G < 8.6e4 * factor,
                       young = G > 1.9e5 * factor && G < 2.2e5 * factor;
            return std::pair(shear || young, young);
        };
        const std::string field = "bodies." + std::string(name) + ".G is " + number_text(G);
        if (says(1).second)
            warnings.push_back(field +
                               ", Young's modulus of steel in N/mm^2. G is the shear modulus, E/(2 (1 + nu)) = " +
                               number_text(std::round(G / (2 * (1 + nu)))) + " N/mm^2 here.");
        else if (is_in_mm && says(pascal).first)
            warnings.push_back(field + ", a modulus of steel in Pa, but the grid is not in metres. Give moduli in " +
                               "N/mm^2 if lengths are in mm.");
    };
    warn_of("upper", problem.bodies.upper);
    warn_of("lower", problem.bodies.lower);
}

}  // namespace

std::vector<std::string> unit_warnings(const ContactProblem& problem, const ContactSolution& solution) {
    Sentences warnings;
    warn_of_pressures_beyond_elasticity(problem, solution, warnings);
    warn_of_strengths_beyond_elasticity(problem, warnings);
    warn_of_moduli(problem, warnings);
    warn_of_friction_in_percent(problem, warnings);
    warn_of_rigid_slip_that_is_no_creepage(problem, warnings);
    warn_of_large_creepages(problem, solution, warnings);
    for (const auto& others : {height_warnings, slow_rolling_warnings})
        for (std::string& sentence : others(problem, solution)) warnings.push_back(std::move(sentence));
    return warnings;
}

}  // namespace contactd
