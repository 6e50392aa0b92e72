// Common variables of contacts and wheels: endpoint, timeouts, friction and accuracy.
#pragma once

#include <array>

#include "variable.hpp"

namespace contactd::fmu {

inline constexpr std::string_view model_keywords[] = {"full", "hertz", "fastsim", "fastrip", "polach"};
inline constexpr Enumeration models{"Model", model_keywords};
inline constexpr std::string_view kinetic_keywords[] = {"none", "linear", "exponential", "rational"};
inline constexpr Enumeration kinetic_laws{"KineticFriction", kinetic_keywords};

inline constexpr auto common_variables = std::to_array<Variable>({
    {.name = "time", .role = Role::time, .unit = "s", .says = "Time, at the end of the last step."},
    text("endpoint", "",
         "Of a daemon, such as ipc:///run/contactd/socket or tcp://host:5555. Empty: solved in process."),
    text("server_key", "", "File with the daemon's public CURVE key. Empty: a connection without keys."),
    text("own_key", "", "File with one's own secret CURVE key."),
    real("limits.step", Role::parameter, "s", 60,
         "A step that takes longer ends with an error; so does the end of an instance."),
    real("limits.start", Role::parameter, "s", 3600,
         "The same of the initialisation, which may wait for finite elements."),
    real("limits.connect", Role::parameter, "s", 5,
         "How long to wait for somebody to listen; never more than limits.step."),
    at_path(
        "setup.model",
        keyword(
            "model", models, 0,
            "full: boundary elements. hertz: closed forms. fastsim, fastrip, polach: Hertz, and theories of rolling.")),
    number("model_number", "model", models,
           "In the place of model: 0 full, 1 hertz, 2 fastsim, 3 fastrip, 4 polach; -1: as model says."),
    at_path("setup.friction.mu", real("friction.mu", Role::input, "", 0.3, "Coefficient of (static) friction.")),
    boolean("friction.none", Role::parameter, false, "No friction: nothing but normal contact is solved."),
    keyword("friction.kinetic.law", kinetic_laws, 0, "How friction falls with the velocity of slip."),
    number("friction.kinetic.law_number", "friction.kinetic.law", kinetic_laws,
           "In the place of friction.kinetic.law: 0 none, 1 linear, 2 exponential, 3 rational; -1: as "
           "friction.kinetic.law says."),
    real("friction.kinetic.mu", Role::tunable, "", 0.2,
         "Coefficient at high velocities of slip, where there is a law."),
    real("friction.kinetic.slip_velocity", Role::tunable, "mm/s", 1000, "The law's scale."),
    real("friction.kinetic.second.fall", Role::parameter, "", 0,
         "What a second term takes of the fall to friction.kinetic.mu; 0: there is none."),
    real("friction.kinetic.second.slip_velocity", Role::parameter, "mm/s", 1000, "That term's scale."),
    real("friction.kinetic.memory.distance", Role::parameter, "mm", 0,
         "Distance of slip over which the coefficient of a particle follows the law; 0: at once."),
    real("friction.kinetic.memory.least_velocity", Role::parameter, "mm/s", 0,
         "Slip velocity from which on it follows slower slip."),
    real("friction.layer.flexibility", Role::parameter, "mm3/N", 0,
         "Of a layer between the surfaces: its thickness over its shear modulus."),
    real("friction.layer.yield_stress", Role::parameter, "N/mm2", 0,
         "Shear stress at which the layer yields; 0: it never does."),
    real("friction.layer.hardening", Role::parameter, "N/mm3", 0,
         "Slope of the yield stress over the length of the layer's flow."),
    real("friction.layer.residual", Role::parameter, "", 0.1, "Part of the yield stress that softening leaves."),
    real(
        "friction.temperature.change", Role::parameter, "", 0,
        "Change of the coefficient as surfaces warm from friction.temperature.reference by friction.temperature.range, "
        "negative where it falls; needs temperature.computed. 0: it does not follow the temperature."),
    real("friction.temperature.reference", Role::parameter, "degC", 0,
         "Temperature up to which the coefficient is friction.mu."),
    real("friction.temperature.range", Role::parameter, "K", 1, "Rise over which it changes."),
    boolean("temperature.computed", Role::parameter, false,
            "Temperatures of the surfaces are computed; of steady rolling along x."),
    real("temperature.upper.conductivity", Role::parameter, "W/(m.K)", 50,
         "Thermal conductivity of the upper body, or the rail; 0: it takes no heat."),
    real("temperature.upper.heat_capacity", Role::parameter, "J/(kg.K)", 450, "Its specific heat capacity."),
    real("temperature.upper.density", Role::parameter, "kg/m3", 7850, "Its density."),
    real("temperature.lower.conductivity", Role::parameter, "W/(m.K)", 50, "The same of the lower body, or the wheel."),
    real("temperature.lower.heat_capacity", Role::parameter, "J/(kg.K)", 450, "The same of the lower body."),
    real("temperature.lower.density", Role::parameter, "kg/m3", 7850, "The same of the lower body."),
    real("temperature.largest", Role::output, "degC", 0,
         "Largest temperature in contact, of all patches; 0 where none is computed."),
    real("temperature.rise", Role::output, "K", 0, "Largest rise by friction alone."),
    real("temperature.heat_upper", Role::output, "N.mm/s", 0,
         "Frictional power that goes into the upper body, or the rail."),
    real("temperature.heat_lower", Role::output, "N.mm/s", 0, "The same of the lower body, or the wheel."),
    at_path("setup.settings.normal.tolerance",
            real("tolerances.normal", Role::parameter, "", 1e-8, "Of the pressures.")),
    at_path("setup.settings.tangential.tolerance",
            real("tolerances.tangential", Role::parameter, "", 1e-6, "Of the tractions.")),
    at_path("setup.settings.outer.tolerance", real("tolerances.outer", Role::parameter, "", 1e-6,
                                                   "Of the loop that unlike bodies, laws of slip and forces need.")),
    integer("tolerances.iterations", Role::parameter, 0,
            "Most of each of these solvers; 0: 1000, and 100 of the outer loop."),
    boolean("accept_unconverged", Role::parameter, false,
            "A step that missed a tolerance counts; otherwise it is discarded."),
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
