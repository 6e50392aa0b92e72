#include "contact_temperature.hpp"

#include <utility>
#include <variant>

#include "contactd/surface_temperature.hpp"

namespace contactd {

void find_temperature(const ContactProblem& problem, ContactSolution& solution, Observer& observer) {
    solution.upper_speed = problem.upper_speed;
    if (!problem.temperature) return;
    const auto& rolling = std::get<Rolling>(problem.motion);
    SurfaceTemperatures found = surface_temperature(
        {problem.grid, *problem.temperature, rolling.velocity, rolling.chi, solution.pressure, solution.traction_x,
         solution.traction_y, solution.slip_x, solution.slip_y, solution.flow_x, solution.flow_y, problem.upper_speed},
        observer);
    solution.upper_temperature = std::move(found.upper_temperature);
    solution.lower_temperature = std::move(found.lower_temperature);
    solution.temperature = found.temperature;
    for (std::string& warning : found.warnings) solution.warnings.push_back(std::move(warning));
}

}  // namespace contactd
