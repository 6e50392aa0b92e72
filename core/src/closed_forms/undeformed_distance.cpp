#include "undeformed_distance.hpp"

#include <cmath>

#include "contactd/error.hpp"

namespace contactd {

std::optional<Paraboloid> paraboloid_of(const ContactProblem& problem) {
    if (const auto* paraboloid = std::get_if<Paraboloid>(&*problem.gap)) return *paraboloid;
    if (const auto* halves = std::get_if<HalfEllipses>(&*problem.gap))
        return radii_of_force(halves->mean(), problem.bodies.materials().normal_compliance(), *problem.Fn);
    const auto* axes = std::get_if<SemiAxes>(&*problem.gap);
    if (axes == nullptr) return {};
    return problem.Fn ? radii_of_force(*axes, problem.bodies.materials().normal_compliance(), *problem.Fn)
                      : radii_of_approach(*axes, *problem.approach);
}

std::vector<double> undeformed_distance(const ContactProblem& problem) {
    if (const auto* array = std::get_if<std::vector<double>>(&*problem.gap)) return *array;
    return sampled(*paraboloid_of(problem), problem.grid);
}

void check_is_curved(double radius, const char* field) {
    if (!(radius > 0 && std::isfinite(radius)))
        throw InvalidArgument(field,
                              "is flat or concave; Hertz's theory requires positive, finite radii Rx and Ry, or Rx "
                              "alone with ics.line_contact");
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
