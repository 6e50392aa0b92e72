#include "force_accuracy_check.hpp"

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/fields/contact_setup.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

/// Refuses a field that the grids around the contact ellipse cannot represent.
[[noreturn]] void refuse_with_accuracy(const std::string& field, const std::string& value,
                                       const std::string& requirement) {
    throw InvalidArgument(field, value + ", but accuracy requires " + requirement + ": change it, or remove accuracy");
}

void require_half_spaces(const ContactProblem& problem) {
    const Bodies& bodies = problem.bodies;
    const std::string half_spaces = "half-spaces in closed form (ics.source analytic)";
    if (bodies.pair || bodies.any_given()) refuse_with_accuracy("ics", "contains a table of coefficients", half_spaces);
    for (const auto& [body, name] : {std::pair(&bodies.upper, "upper"), std::pair(&bodies.lower, "lower")}) {
        if (body->viscoelastic)
            refuse_with_accuracy(std::string("bodies.") + name + ".viscoelastic", "is given", "elastic bodies");
        if (!body->material.is_rigid() && *body->computed() != Ics{})
            refuse_with_accuracy("ics", std::string("of the ") + name + " body are not those of a half-space",
                                 half_spaces);
    }
    if (!bodies.materials().quasi_identical())
        refuse_with_accuracy("bodies", "are dissimilar", "quasi-identical bodies, which have the same (1 - 2 nu)/G");
}

void require_coulomb(const ContactProblem& problem) {
    const FrictionLaw& friction = *problem.friction;
    const std::string coulomb = "Coulomb friction with one coefficient";
    if (friction.mu.size() != 1) refuse_with_accuracy("friction.mu", "differs from element to element", coulomb);
    if (friction.kinetic) refuse_with_accuracy("friction.kinetic", "is given", coulomb);
    if (friction.layer) refuse_with_accuracy("friction.layer", "is given", coulomb);
    if (friction.follows_temperature()) refuse_with_accuracy("friction.temperature", "is given", coulomb);
    if (!problem.rigid_slip.empty())
        refuse_with_accuracy("friction.rigid_slip", "is given for each element", "creepages and spin");
}

void require_steady_rolling(const ContactProblem& problem) {
    const auto* rolling = std::get_if<Rolling>(&problem.motion);
    if (rolling == nullptr) refuse_with_accuracy("friction", "has a shift", "steady rolling (friction.rolling)");
    if (!rolling->steady()) refuse_with_accuracy("friction.rolling.kind", "is transient", "steady rolling");
    if (!rolling->force.empty())
        refuse_with_accuracy("friction.rolling.force", "is prescribed",
                             "prescribed creepages, friction.rolling.xi and eta");
    if (constexpr double rounding = 1e-9; std::abs(std::sin(2 * rolling->chi)) > rounding)
        refuse_with_accuracy("friction.rolling.chi", "is " + number_text(rolling->chi),
                             "rolling along an axis of the contact ellipse, a multiple of pi/2");
}

}  // namespace

void check_force_accuracy(const ContactProblem& problem, bool complete) {
    if (!problem.accuracy) return;
    if (!(*problem.accuracy >= finest_force_accuracy && *problem.accuracy <= coarsest_force_accuracy))
        throw InvalidArgument("accuracy", "is " + number_text(*problem.accuracy) + "; it must lie in [" +
                                              number_text(finest_force_accuracy) + ", " +
                                              number_text(coarsest_force_accuracy) + "], as a share of mu Fn");
    if (problem.model != Model::full)
        refuse_with_accuracy("model", "is " + std::string(name_of(problem.model)), "model full");
    if (problem.normal_model != NormalModel::of_model)
        refuse_with_accuracy("normal_model", "is " + std::string(name_of(problem.normal_model)),
                             "pressures by boundary elements");
    if (problem.columns) refuse_with_accuracy("columns", "are given", "a plane contact");
    if (problem.regions) refuse_with_accuracy("regions", "are given", "a single contact");
    if (problem.sheet_flexibility > 0)
        refuse_with_accuracy("sheet_flexibility", "is " + number_text(problem.sheet_flexibility) + " mm^3/N",
                             "no sheet");
    require_half_spaces(problem);
    if (problem.gap && std::holds_alternative<std::vector<double>>(*problem.gap))
        refuse_with_accuracy("gap.array", "has one distance per element", "a paraboloid or semi_axes");
    if (problem.friction) {
        require_coulomb(problem);
        require_steady_rolling(problem);
    } else if (complete) {
        refuse_with_accuracy("friction", "is missing", "rolling contact with friction");
    }
}

}  // namespace contactd
