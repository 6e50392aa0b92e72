#include "hertz_of_problem.hpp"

#include <cmath>
#include <variant>

#include "contactd/error.hpp"

namespace contactd {

void check_is_curved(double radius, const char* field) {
    if (!(radius > 0 && std::isfinite(radius)))
        throw InvalidArgument(field,
                              "is flat or concave; Hertz's theory needs both radii of the gap positive and finite, "
                              "or, of a contact that does not change along y, ics.line_contact and Rx");
}

HertzContact hertz_of(const ContactProblem& problem) {
    const double compliance = problem.bodies.materials().normal_compliance();
    if (const auto* halves = std::get_if<HalfEllipses>(&*problem.gap))
        return hertz_of_semi_axes_and_force(halves->mean(), compliance, *problem.Fn);
    if (const auto* axes = std::get_if<SemiAxes>(&*problem.gap))
        return problem.Fn ? hertz_of_semi_axes_and_force(*axes, compliance, *problem.Fn)
                          : hertz_of_semi_axes_and_approach(*axes, compliance, *problem.approach);
    const auto& paraboloid = std::get<Paraboloid>(*problem.gap);
    check_is_curved(paraboloid.Rx, "gap.paraboloid.Rx");
    check_is_curved(paraboloid.Ry, "gap.paraboloid.Ry");
    return problem.Fn ? hertz_of_force(paraboloid, compliance, *problem.Fn)
                      : hertz_of_approach(paraboloid, compliance, *problem.approach);
}

}  // namespace contactd
