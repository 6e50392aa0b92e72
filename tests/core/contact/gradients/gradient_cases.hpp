// Provides contacts with known gradients, and gradients by central differences.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "contact/contact_cases.hpp"
#include "contactd/contact_gradients.hpp"

namespace contactd::test {

inline const std::vector<GradientInput> all_of_a_step{GradientInput::gap, GradientInput::mu, GradientInput::rigid_slip,
                                                      GradientInput::materials};

inline ContactGradients gradients_of(const ContactProblem& problem, const ContactSolution& solution,
                                     const std::vector<Cotangents>& outputs, const std::vector<GradientInput>& by) {
    Observer observer;
    return contact_gradients(problem, operators_of(problem, pair_table(problem)), solution, outputs, by, observer);
}

/// Returns an output of one answer.
inline Cotangents output_of(double Cotangents::* answer, double value = 1) {
    Cotangents output;
    output.*answer = value;
    return output;
}

/// Returns h at the element centres.
inline Values distance_on(const Grid& grid, const std::function<double(double, double)>& h) {
    Values values;
    for (int iy = 0; iy < grid.ny; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) values.push_back(h(grid.x(ix), grid.y(iy)));
    return values;
}

inline Values bump(const Grid& grid, double x, double y, double width) {
    return distance_on(grid, [&](double at_x, double at_y) {
        return std::exp(-(std::pow(at_x - x, 2) + std::pow(at_y - y, 2)) / (width * width));
    });
}

inline double along(const Values& gradient, const Values& direction) {
    double sum = 0;
    for (std::size_t i = 0; i < gradient.size(); ++i) sum += gradient[i] * direction[i];
    return sum;
}

/// Tightens the tolerances, so that differences of solutions are meaningful.
inline ContactProblem tight(ContactProblem problem) {
    problem.settings = {{1e-12, 3000}, {1e-11, 3000}, {1e-11, 300}};
    return problem;
}

/// Creates a small contact of soft bodies under an approach (N1).
inline ContactProblem pressed_patch() {
    ContactProblem problem;
    problem.grid = Grid::of_elements(16, 16, 2.4 / 16, 2.4 / 16);
    problem.bodies = {{200, 0.42}, {200, 0.42}};
    problem.gap = distance_on(
        problem.grid, [](double x, double y) { return std::pow(x - 0.03, 2) / 100 + std::pow(y - 0.02, 2) / 100; });
    problem.approach = 0.02;
    return tight(problem);
}

/// Creates the same contact, shifted and rotated (S1).
inline ContactProblem shifted_patch() {
    ContactProblem problem = pressed_patch();
    problem.friction = FrictionLaw{{0.4}};
    problem.motion = Shift{{0.006, 0.002}, 0.001};
    return problem;
}

inline Rolling creeping(double xi, double eta, double phi) {
    Rolling rolling;
    rolling.xi = xi;
    rolling.eta = eta;
    rolling.phi = phi;
    return rolling;
}

inline ContactProblem rolling_on(const Grid& grid, const Bodies& bodies, double mu, const Rolling& rolling) {
    ContactProblem problem;
    problem.grid = grid;
    problem.bodies = bodies;
    problem.gap =
        distance_on(grid, [](double x, double y) { return std::pow(x - 0.13, 2) / 920 + std::pow(y - 0.11, 2) / 300; });
    problem.approach = 0.06;
    problem.friction = FrictionLaw{{mu}};
    problem.motion = rolling;
    return tight(problem);
}

/// Creates a rolling contact of steel (R1), and one of steel on a softer body (D1).
inline ContactProblem rolling_steel() {
    return rolling_on(Grid::of_elements(20, 16, 0.7, 0.6), {{82000, 0.28}, {82000, 0.28}}, 0.3,
                      creeping(0.0012, -0.0006, 0.0002));
}
inline ContactProblem rolling_on_softer() {
    return rolling_on(Grid::of_elements(16, 14, 0.85, 0.7), {{82000, 0.28}, {10000, 0.4}}, 0.3,
                      creeping(0.001, 0.0004, 0.0002));
}

}  // namespace contactd::test
