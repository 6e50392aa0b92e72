#include "viscoelastic_influence.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "contactd/error.hpp"
#include "influence/viscoelastic/rolling_table.hpp"
#include "operators/shifted_operator.hpp"
#include "operators/viscoelastic/viscoelastic_operator.hpp"

namespace contactd {
namespace {

/// Returns the shares of a body in the compliance of the pair for a long wave, along x, y and z, which are those of
/// A[i,i].
std::array<double, 3> shares_of(const Material& body, const MaterialPair& pair) {
    const auto along = [&](const auto& compliance) {
        const double of_body = compliance(body);
        return of_body / (compliance(pair.upper) + compliance(pair.lower));
    };
    const double in_plane = along([](const Material& m) { return m.is_rigid() ? 0 : (1 - 0.5 * m.nu) / m.G; });
    return {in_plane, in_plane, along([](const Material& m) { return m.is_rigid() ? 0 : (1 - m.nu) / m.G; })};
}

}  // namespace

ContactInfluence viscoelastic_influence(const ContactProblem& problem, IcTable elastic, const Observer& observer) {
    const auto* rolling = problem.friction ? std::get_if<Rolling>(&problem.motion) : nullptr;
    if (rolling == nullptr)
        throw InvalidArgument("friction.rolling",
                              "is missing; coefficients of viscoelastic bodies depend on the velocity of rolling");
    const Bodies& bodies = problem.bodies;
    const bool is_forward = std::cos(rolling->chi) > 0;
    const RollingHalfSpaces half_spaces{bodies, rolling->velocity, is_forward};
    const Grid& grid = problem.grid;
    std::vector<CreepOfWaves> creep;
    for (const Body* body : {&bodies.upper, &bodies.lower})
        if (body->viscoelastic)
            creep.push_back({body->viscoelastic->f, (is_forward ? 1 : -1) * rolling->velocity * body->viscoelastic->tau,
                             shares_of(body->material, bodies.materials())});
    RollingTable table = rolling_table(half_spaces, grid, observer);
    const ShiftedTable ahead = rolling_table_ahead(half_spaces, grid, step_length(*rolling, grid), observer);
    ContactInfluence influence;
    influence.increment = std::make_shared<const ShiftedOperator>(change_over_step(table, ahead));
    influence.current = std::make_shared<const ViscoelasticOperator>(
        elastic.nx == grid.nx && elastic.ny == grid.ny ? std::move(elastic) : cropped(elastic, grid.nx, grid.ny),
        std::move(table), std::move(creep), grid.dx);
    return influence;
}

}  // namespace contactd
