// Written by ./dev generate from proto/schema: edit it there.

#include "contactd/fields/grid_arrays.hpp"

namespace contactd {

constexpr std::array<std::vector<double> ContactSolution::*, 16> solution_arrays{
    nullptr,
    &ContactSolution::pressure,
    &ContactSolution::traction_x,
    &ContactSolution::traction_y,
    &ContactSolution::slip_x,
    &ContactSolution::slip_y,
    &ContactSolution::displacement_x,
    &ContactSolution::displacement_y,
    &ContactSolution::displacement_z,
    &ContactSolution::flow_x,
    &ContactSolution::flow_y,
    &ContactSolution::yield_stress,
    &ContactSolution::friction_coefficient,
    &ContactSolution::upper_temperature,
    &ContactSolution::lower_temperature,
    &ContactSolution::pressure_by_approach};

constexpr std::array<HistoryArray, 5> history_arrays{
    HistoryArray{"pressure", &SurfaceState::pressure, &ContactSolution::pressure},
    HistoryArray{"traction_x", &SurfaceState::traction_x, &ContactSolution::traction_x},
    HistoryArray{"traction_y", &SurfaceState::traction_y, &ContactSolution::traction_y},
    HistoryArray{"yield_stress",
                 &SurfaceState::yield_stress,
                 &ContactSolution::yield_stress,
                 {.least = 0, .least_excluded = true},
                 [](const FrictionLaw& law) -> bool { return law.layer && law.layer->hardens(); },
                 [](const FrictionLaw& law, [[maybe_unused]] std::size_t element) -> std::optional<double> {
                     return law.layer ? std::optional(law.layer->yield_stress) : std::nullopt;
                 }},
    HistoryArray{"friction_coefficient",
                 &SurfaceState::friction_coefficient,
                 &ContactSolution::friction_coefficient,
                 {.least = 0},
                 [](const FrictionLaw& law) -> bool { return law.kinetic && law.kinetic->memory; },
                 [](const FrictionLaw& law, [[maybe_unused]] std::size_t element) -> std::optional<double> {
                     return law.mu_of(element);
                 }},
};

}  // namespace contactd
