#include "undeformed_distance.hpp"

#include "hertz.hpp"

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

}  // namespace contactd
