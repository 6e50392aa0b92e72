#include "contactd/contact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contactd/error.hpp"
#include "number_text.hpp"

namespace contactd {
namespace {

void check_array(const std::vector<double>& values, std::size_t size, const char* field) {
    if (values.size() != size)
        throw InvalidArgument(field, "has " + std::to_string(values.size()) + " values; the grid has " +
                                         std::to_string(size) + " elements");
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
        throw InvalidArgument(field, "holds a value that is not finite");
}

void check_estimate(const std::vector<double>& values, std::size_t size, const char* field) {
    if (!values.empty()) check_array(values, size, field);
}

void check_finite(double value, const char* field) {
    if (!std::isfinite(value)) throw InvalidArgument(field, "is not finite; it must be a length");
}

void check_settings(const SolverSettings& settings, const std::string& field) {
    if (!(settings.tolerance > 0 && settings.tolerance < 1))
        throw InvalidArgument(field + ".tolerance",
                              "is " + number_text(settings.tolerance) + "; it must lie in (0, 1)");
    if (settings.max_iterations < 1)
        throw InvalidArgument(field + ".max_iterations",
                              "is " + std::to_string(settings.max_iterations) + "; it must be at least 1");
}

}  // namespace

std::vector<double> paraboloid(const Grid& grid, double Rx, double Ry) {
    std::vector<double> h(grid.size());
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
            const double x = grid.x(ix), y = grid.y(iy);
            h[static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix)] =
                x * x / (2 * Rx) + y * y / (2 * Ry);
        }
    return h;
}

void validate(const ContactProblem& problem) {
    validate(problem.grid, "grid");
    if (problem.given_ics) {
        validate(*problem.given_ics, problem.grid);
    } else {
        const bool incompressible_allowed = problem.ics.source == IcSource::analytic;
        validate(problem.bodies.upper, "bodies.upper", incompressible_allowed);
        validate(problem.bodies.lower, "bodies.lower", incompressible_allowed);
    }
    const std::size_t size = problem.grid.size();
    check_array(problem.undeformed_distance, size, "gap");
    check_finite(problem.approach, "approach");
    if (problem.friction) {
        const Friction& friction = *problem.friction;
        if (!std::isfinite(friction.mu) || friction.mu < 0)
            throw InvalidArgument("friction.mu", "is " + number_text(friction.mu) + "; it must be zero or positive");
        check_finite(friction.rigid_shift_x, "friction.rigid_shift");
        check_finite(friction.rigid_shift_y, "friction.rigid_shift");
    }
    check_settings(problem.normal_settings, "settings.normal");
    check_settings(problem.tangential_settings, "settings.tangential");
    check_estimate(problem.initial_pressure, size, "initial.pressure");
    check_estimate(problem.initial_traction_x, size, "initial.traction_x");
    check_estimate(problem.initial_traction_y, size, "initial.traction_y");
}

}  // namespace contactd
