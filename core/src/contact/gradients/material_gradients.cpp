#include "material_gradients.hpp"

#include <array>

#include "contact/support/solver_support.hpp"
#include "contactd/half_space.hpp"
#include "elastic_slip.hpp"

namespace contactd {
namespace {

// Holds the change of an output if the coefficients of a half-space with G = 1 below a rigid body are added: without
// coupling, and its part by coupling, which has the opposite sign for the upper body.
struct Effect {
    double plain = 0, coupling = 0;
};

std::vector<Effect> effects_of(const ContactProblem& problem, const Ics& ics, double nu,
                               const ContactSolution& solution, const std::vector<Adjoint>& outputs,
                               const Observer& observer) {
    const Grid& grid = problem.grid;
    const Material material{1, nu};
    ContactProblem alone = problem;
    alone.bodies = {{Material::rigid()}, {material, ics}};
    const ContactInfluence influence = make_influence(
        alone, half_space_table({ics, material, grid.dx, grid.dy, grid.nx, grid.ny}, observer), observer);
    const ElasticEffects effects = elastic_effects(alone, influence, solution);
    std::vector<Effect> result;
    for (const Adjoint& output : outputs)
        result.push_back(
            {inner(output.slip, effects.slip) - dot(output.normal, effects.normal),
             inner(output.slip, effects.slip_by_coupling) - dot(output.normal, effects.normal_by_coupling)});
    return result;
}

GradientByMaterial by_material(const Material& material, double at_zero, double at_half) {
    const double by_nu = (at_half - at_zero) / 0.5;
    return {-(at_zero + material.nu * by_nu) / (material.G * material.G), by_nu / material.G};
}

}  // namespace

std::vector<GradientsByMaterials> by_materials(const ContactProblem& problem, const ContactSolution& solution,
                                               const std::vector<Adjoint>& outputs, const Observer& observer) {
    const auto& [upper, lower, pair] = problem.bodies;
    std::vector<GradientsByMaterials> result(outputs.size());
    std::array<std::vector<Effect>, 2> effects;
    const Ics* last = nullptr;
    for (const Body* body : {&upper, &lower}) {
        if (body->material.is_rigid()) continue;
        const Ics& ics = *body->computed();
        if (last == nullptr || !(*last == ics))
            effects = {effects_of(problem, ics, 0, solution, outputs, observer),
                       effects_of(problem, ics, 0.5, solution, outputs, observer)};
        last = &ics;
        const double sign = body == &upper ? -1 : 1;
        for (std::size_t k = 0; k < outputs.size(); ++k) {
            const auto of = [&](const Effect& effect) { return effect.plain + sign * effect.coupling; };
            (body == &upper ? result[k].upper : result[k].lower) =
                by_material(body->material, of(effects[0][k]), of(effects[1][k]));
        }
    }
    return result;
}

}  // namespace contactd
