#include "passage_stress.hpp"

#include <algorithm>

#include "contactd/subsurface.hpp"

namespace contactd {
namespace {

/// Depths are closer together near the surface. Depths below the size of an element would show the steps of the
/// tractions.
std::vector<double> chosen_depths(double half_length, double element) {
    std::vector<double> depths{0};
    for (int i = 1; i <= 14; ++i) depths.push_back(0.05 * i * half_length);
    for (const double share : {0.8, 0.9, 1.0, 1.2, 1.5, 2.0}) depths.push_back(share * half_length);
    std::erase_if(depths, [&](double depth) { return depth > 0 && depth < element && depth < 0.5 * half_length; });
    return depths;
}

SubsurfaceStress stresses(const ContactProblem& problem, const SurfaceTractions& tractions, ContactBody side,
                          std::span<const double> angles, const StressBlock& block, Observer& observer) {
    const Body& body = side == ContactBody::upper ? problem.bodies.upper : problem.bodies.lower;
    if (const Layers* layers = body.layered())
        return subsurface_stress(problem.grid, tractions, *layers, block, observer);
    const double nu = body.material.nu;
    if (is_line_contact(problem)) return subsurface_stress(problem.grid, tractions, PlaneStrain{nu}, block, observer);
    if (angles.empty()) return subsurface_stress(problem.grid, tractions, nu, block, observer);
    std::vector<double> own(angles.begin(), angles.end());
    if (side == ContactBody::upper)  // The frame of the upper body is the mirror image.
        for (double& angle : own) angle = 0 - angle;
    return subsurface_stress(problem.grid, tractions, nu, own, block, observer);
}

}  // namespace

ContactBox contact_box(const Grid& grid, const std::vector<double>& pressure) {
    ContactBox box{grid.nx, 0, grid.ny, 0};
    for (std::size_t i = 0; i < pressure.size(); ++i) {
        if (!(pressure[i] > 0)) continue;
        const int ix = static_cast<int>(i) % grid.nx, iy = static_cast<int>(i) / grid.nx;
        box = {std::min(box.first_x, ix), std::max(box.end_x, ix + 1), std::min(box.first_y, iy),
               std::max(box.end_y, iy + 1)};
    }
    return box;
}

PassageStress passage_stress(const ContactProblem& problem, const ContactSolution& solution, const ContactBox& box,
                             std::span<const double> angles, Observer& observer) {
    const Grid& grid = problem.grid;
    const int length = box.end_x - box.first_x;
    const bool is_line = is_line_contact(problem);
    PassageStress passage{.rows = box.rows(), .nx = static_cast<std::size_t>(3 * length), .dx = grid.dx, .stress = {}};
    const double along = 0.5 * length * grid.dx, across = 0.5 * static_cast<double>(box.rows()) * grid.dy;
    passage.depths = problem.fatigue->passage->depths;
    if (passage.depths.empty())
        passage.depths = is_line ? chosen_depths(along, grid.dx)
                                 : chosen_depths(std::min(along, across), std::max(grid.dx, grid.dy));
    StressBlock block;
    for (int i = 0; i < 3 * length; ++i) block.x.push_back(grid.x(0) + (box.first_x - length + i) * grid.dx);
    for (int iy = box.first_y; iy < box.end_y; ++iy) block.y.push_back(grid.y(iy));
    for (const double depth : passage.depths) block.z.push_back(0 - depth);
    const ContactBody side = problem.fatigue->body == WornBody::upper ? ContactBody::upper : ContactBody::lower;
    passage.stress = stresses(problem, tractions_on(side, solution.pressure, solution.traction_x, solution.traction_y),
                              side, angles, block, observer);
    return passage;
}

}  // namespace contactd
