// Lists common variables of contacts and wheels: endpoint, timeouts, friction and accuracy.
#pragma once

#include <array>

#include "generated/enumerations.hpp"
#include "variable.hpp"

namespace contactd::fmu {

inline constexpr auto common_variables = std::to_array<Variable>({
    {.name = "time", .role = Role::time, .unit = "s", .says = "Time, at the end of the last step."},
    text("endpoint", "",
         "Address of a daemon, such as ipc:///run/contactd/socket or tcp://host:5555. Empty: solves in process."),
    text("server_key", "", "File with the daemon's public CURVE key. Empty: a connection without keys."),
    text("own_key", "", "File with your own secret CURVE key."),
    real("limits.step", Role::parameter, "s", 60,
         "Time limit of a step, and of the end of an instance. A step that takes longer ends with an error."),
    real("limits.start", Role::parameter, "s", 3600,
         "Time limit of the initialisation, which may wait for finite elements."),
    real("limits.connect", Role::parameter, "s", 5, "Time limit of the connection to a daemon; at most limits.step."),
    at_path(
        "setup.model",
        keyword(
            "model", enumerations::model, 0,
            "full: boundary elements. hertz: closed forms. fastsim, fastrip, polach: Hertz, and theories of rolling.")),
    number("model_number", "model", enumerations::model),
    at_path("setup.friction.mu", real("friction.mu", Role::input, "", 0.3, "Coefficient of (static) friction.")),
    boolean("friction.none", Role::parameter, false, "True for frictionless contact."),
    keyword("friction.kinetic.law", enumerations::kinetic_friction, 0,
            "Law by which friction decreases with the slip velocity."),
    number("friction.kinetic.law_number", "friction.kinetic.law", enumerations::kinetic_friction),
    real("friction.kinetic.mu", Role::tunable, "", 0.2, "Coefficient at high slip velocities. Used with a law."),
    real("friction.kinetic.slip_velocity", Role::tunable, "mm/s", 1000, "Slip velocity of the law."),
    real("friction.kinetic.second.fall", Role::parameter, "", 0,
         "Part of the decrease to friction.kinetic.mu that follows a second term; 0: no second term."),
    real("friction.kinetic.second.slip_velocity", Role::parameter, "mm/s", 1000, "Slip velocity of the second term."),
    real("friction.kinetic.memory.distance", Role::parameter, "mm", 0,
         "Slip distance over which the coefficient of a particle follows the law; 0: at once."),
    real("friction.kinetic.memory.least_velocity", Role::parameter, "mm/s", 0,
         "Lower bound of the slip velocity with which the coefficient follows the law."),
    real("friction.layer.flexibility", Role::parameter, "mm3/N", 0,
         "Flexibility of an interfacial layer: thickness over shear modulus."),
    real("friction.layer.yield_stress", Role::parameter, "N/mm2", 0,
         "Shear stress at which the layer yields; 0: it never yields."),
    real("friction.layer.hardening", Role::parameter, "N/mm3", 0,
         "Slope of the yield stress over the accumulated plastic flow of the layer."),
    real("friction.layer.residual", Role::parameter, "", 0.1, "Part of the yield stress that softening leaves."),
    real("friction.temperature.change", Role::parameter, "", 0,
         "Change of the coefficient as surfaces warm from friction.temperature.reference by "
         "friction.temperature.range, negative for falling friction. Requires temperature.computed. 0: the coefficient "
         "does not depend on the temperature."),
    real("friction.temperature.reference", Role::parameter, "degC", 0,
         "Temperature below which the coefficient is friction.mu."),
    real("friction.temperature.range", Role::parameter, "K", 1,
         "Rise of the temperature over which the coefficient changes."),
    boolean("temperature.computed", Role::parameter, false,
            "True to compute surface temperatures. Requires steady rolling along x."),
    real("temperature.upper.conductivity", Role::parameter, "W/(m.K)", 50,
         "Thermal conductivity of the upper body, or the rail; with 0 it takes no heat."),
    real("temperature.upper.heat_capacity", Role::parameter, "J/(kg.K)", 450,
         "Specific heat capacity of the upper body, or the rail."),
    real("temperature.upper.density", Role::parameter, "kg/m3", 7850, "Density of the upper body, or the rail."),
    real("temperature.lower.conductivity", Role::parameter, "W/(m.K)", 50,
         "Thermal conductivity of the lower body, or the wheel; with 0 it takes no heat."),
    real("temperature.lower.heat_capacity", Role::parameter, "J/(kg.K)", 450,
         "Specific heat capacity of the lower body, or the wheel."),
    real("temperature.lower.density", Role::parameter, "kg/m3", 7850, "Density of the lower body, or the wheel."),
    real("temperature.largest", Role::output, "degC", 0,
         "Largest temperature in the contact, of all patches; 0 if none is computed."),
    real("temperature.rise", Role::output, "K", 0, "Largest rise of the temperature by friction alone."),
    real("temperature.heat_upper", Role::output, "N.mm/s", 0,
         "Frictional power that flows into the upper body, or the rail."),
    real("temperature.heat_lower", Role::output, "N.mm/s", 0,
         "Frictional power that flows into the lower body, or the wheel."),
    at_path("setup.settings.normal.tolerance",
            real("tolerances.normal", Role::parameter, "", 1e-8, "Tolerance of the pressures.")),
    at_path("setup.settings.tangential.tolerance",
            real("tolerances.tangential", Role::parameter, "", 1e-6, "Tolerance of the tractions.")),
    at_path("setup.settings.outer.tolerance", real("tolerances.outer", Role::parameter, "", 1e-6,
                                                   "Tolerance of the outer iterations, which dissimilar bodies, "
                                                   "kinetic friction and prescribed forces require.")),
    integer("tolerances.iterations", Role::parameter, 0,
            "Iteration limit of each of these solvers; 0: 1000, and 100 for the outer iterations."),
    boolean("accept_unconverged", Role::parameter, false,
            "True to accept a step that missed a tolerance; otherwise it is discarded."),
});

/// Concatenates lists.
template <std::size_t n, std::size_t m>
consteval std::array<Variable, n + m> joined(const std::array<Variable, n>& first,
                                             const std::array<Variable, m>& then) {
    std::array<Variable, n + m> all;
    for (std::size_t k = 0; k < n; ++k) all[k] = first[k];
    for (std::size_t k = 0; k < m; ++k) all[n + k] = then[k];
    return all;
}

}  // namespace contactd::fmu
