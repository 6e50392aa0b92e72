#include "simplified_derivatives.hpp"

#include <cmath>

#include "cattaneo_mindlin.hpp"
#include "closed_forms/elements/element_friction.hpp"
#include "derivative_table.hpp"
#include "fastsim.hpp"
#include "vermeulen_johnson.hpp"

namespace contactd {
namespace {

using Table = DerivativeTable;

struct KnownMotion {
    std::array<double, 3> motion;
    ForcesByMotion by_motion;
    double size_exponent;  // exponent of Fn in the translation with the same slipping part of the contact
};

KnownMotion known_motion(const ContactProblem& problem, const EllipticContact& contact, const Motion& motion) {
    const double mu = problem.friction->mu[0];
    if (const auto* shift = std::get_if<Shift>(&motion))
        return {{shift->rigid_shift.x, shift->rigid_shift.y, 0},
                mu > 0 ? cattaneo_mindlin_by_motion(contact, mu, *shift) : ForcesByMotion{},
                mu > 0 ? cattaneo_mindlin_exponent(contact, mu, *shift) : 0};
    const auto& rolling = std::get<Rolling>(motion);
    ForcesByMotion by_motion{};
    if (mu > 0 && rolls_on_elements(problem)) {
        const TractionBound bound =
            problem.model == Model::fastsim ? problem.simplified.bound : TractionBound::elliptic;
        by_motion = element_friction_by_motion(problem, patch_of(problem.grid, contact, bound), rolling);
    } else if (mu > 0) {
        by_motion = problem.model == Model::fastsim ? fastsim_by_motion(contact, mu, rolling)
                                                    : vermeulen_johnson_by_motion(contact, mu, rolling);
    }
    return {{rolling.xi, rolling.eta, rolling.phi}, by_motion, 1.0 / contact.force_power()};
}

// Contacts of one gap are similar to each other: their axes grow as Fn^(1/3), and with F = mu Fn f(motion)
//
//     F / (mu Fn) is the same for the same  xi, eta / (mu Fn^(1/3)),  phi / mu,  shift / (mu Fn^(2/3)),
//
// and so is Mz / (mu Fn^(4/3)). Therefore, derivatives by friction and by Fn follow from those by the motion. The width
// of a strip grows as Fn^(1/2), and its shift with cattaneo_mindlin_exponent.
void take_friction(const KnownMotion& known, double mu, const EllipticContact& contact, const ContactSolution& solution,
                   Table& table) {
    const std::array forces{solution.forces.Fx, solution.forces.Fy, solution.forces.Mz};
    const double Fn = solution.forces.Fn, by_approach = table.values[Table::Fn][Table::approach];
    for (std::size_t row = 0; row < 3; ++row) {
        const auto& by = known.by_motion[row];
        auto& values = table.values[Table::Fx + row];
        const double by_translation = known.motion[0] * by[0] + known.motion[1] * by[1];
        const double by_all = by_translation + known.motion[2] * by[2];
        const double exponent = row == 2 ? 1 + 1.0 / contact.force_power() : 1;
        values = {(exponent * forces[row] - known.size_exponent * by_translation) / Fn * by_approach, by[0], by[1],
                  by[2], mu > 0 ? (forces[row] - by_all) / mu : 0};
    }
}

// The approach of a strip grows as Fn (ln(2 datum/a) + 1/2), in which the logarithm decreases by 1/2 if Fn grows
// e-fold.
double stiffness(const EllipticContact& contact, double approach) {
    if (!contact.is_strip()) return 1.5 * contact.Fn / approach;
    const double logarithm = std::log(2 * contact.datum / contact.axes.a);
    return contact.Fn / approach * (logarithm + 0.5) / logarithm;
}

}  // namespace

Derivatives simplified_derivatives(const ContactProblem& problem, const EllipticContact& contact,
                                   const ContactSolution& solution) {
    DerivativeTable table;
    table.values[Table::Fn][Table::approach] = stiffness(contact, solution.approach);
    if (problem.friction) {
        const double mu = problem.friction->mu[0];
        take_friction(known_motion(problem, contact, *solution.motion), mu, contact, solution, table);
        table.has_rotation = problem.model != Model::hertz;
        table.has_mu = mu > 0;
    }
    return named(table, problem);
}

}  // namespace contactd
