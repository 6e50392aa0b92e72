// The variables of a plain contact: two bodies on one grid, under a force or an approach, rolling or shifted.
#pragma once

#include "common_variables.hpp"

namespace contactd::fmu {

inline constexpr std::string_view gap_keywords[] = {"radii", "semi_axes"};
inline constexpr Enumeration gaps{"Gap", gap_keywords};
inline constexpr std::string_view load_keywords[] = {"force", "approach"};
inline constexpr Enumeration loads{"Load", load_keywords};
inline constexpr std::string_view motion_keywords[] = {"steady", "transient", "shift"};
inline constexpr Enumeration motions{"Motion", motion_keywords};
inline constexpr std::string_view coefficient_keywords[] = {"half_space", "half_space_by_elements", "block_by_elements",
                                                            "layer", "viscoelastic"};
inline constexpr Enumeration coefficients{"Coefficients", coefficient_keywords};

namespace detail {
inline constexpr auto contact_alone = std::to_array<Variable>({
    integer("grid.nx", Role::parameter, 25, "Elements along x."),
    integer("grid.ny", Role::parameter, 25, "Elements along y."),
    real("grid.dx", Role::parameter, "mm", 0.56, "Size of an element along x. The middle of the grid is the origin."),
    real("grid.dy", Role::parameter, "mm", 0.56, "Size of an element along y."),
    real("upper.G", Role::parameter, "N/mm2", 82000, "Shear modulus of the upper body."),
    real("upper.nu", Role::parameter, "", 0.28, "Poisson's ratio of the upper body."),
    boolean("upper.rigid", Role::parameter, false, "True if the upper body is rigid."),
    keyword("upper.coefficients", coefficients, 0,
            "Kind of the upper body: in closed form, by finite elements, layered, or viscoelastic."),
    number("upper.coefficients_number", "upper.coefficients", coefficients,
           "Overrides upper.coefficients: 0 half_space, 1 half_space_by_elements, 2 block_by_elements, 3 layer, 4 "
           "viscoelastic; -1: upper.coefficients applies."),
    real("upper.layer.thickness", Role::parameter, "mm", 1,
         "Thickness of the layer on the upper body. Its base has upper.G and upper.nu."),
    real("upper.layer.G", Role::parameter, "N/mm2", 82000, "Shear modulus of the layer on the upper body."),
    real("upper.layer.nu", Role::parameter, "", 0.28, "Poisson's ratio of the layer on the upper body."),
    real("upper.viscoelastic.f", Role::parameter, "", 1,
         "Delayed compliance of a viscoelastic upper body divided by the instantaneous one, which follows from "
         "upper.G."),
    real("upper.viscoelastic.tau", Role::parameter, "s", 0.01, "Retardation time of creep of the upper body."),
    real("lower.G", Role::parameter, "N/mm2", 82000, "Shear modulus of the lower body."),
    real("lower.nu", Role::parameter, "", 0.28, "Poisson's ratio of the lower body."),
    boolean("lower.rigid", Role::parameter, false, "True if the lower body is rigid."),
    keyword("lower.coefficients", coefficients, 0, "Kind of the lower body, like upper.coefficients."),
    number("lower.coefficients_number", "lower.coefficients", coefficients,
           "Overrides lower.coefficients, like upper.coefficients_number; -1: lower.coefficients applies."),
    real("lower.layer.thickness", Role::parameter, "mm", 1,
         "Thickness of the layer on the lower body. Its base has lower.G and lower.nu."),
    real("lower.layer.G", Role::parameter, "N/mm2", 82000, "Shear modulus of the layer on the lower body."),
    real("lower.layer.nu", Role::parameter, "", 0.28, "Poisson's ratio of the layer on the lower body."),
    real("lower.viscoelastic.f", Role::parameter, "", 1,
         "Delayed compliance of a viscoelastic lower body divided by the instantaneous one, which follows from "
         "lower.G."),
    real("lower.viscoelastic.tau", Role::parameter, "s", 0.01, "Retardation time of creep of the lower body."),
    real("elements.accuracy", Role::parameter, "", 1e-3, "Largest relative error of coefficients by finite elements."),
    real("elements.L_over_h", Role::parameter, "", 640, "Half the width of a block over the size of an element."),
    keyword("gap.kind", gaps, 0,
            "radii: h = x^2/(2 Rx) + y^2/(2 Ry). semi_axes: the gap of a Hertzian contact with these semi-axes."),
    number("gap.kind_number", "gap.kind", gaps, "Overrides gap.kind: 0 radii, 1 semi_axes; -1: gap.kind applies."),
    real("gap.Rx", Role::tunable, "mm", 460, "Combined radius of curvature along x."),
    real("gap.Ry", Role::tunable, "mm", 300, "Combined radius of curvature along y."),
    real("gap.a", Role::tunable, "mm", 6, "Semi-axis along x."),
    real("gap.b", Role::tunable, "mm", 4, "Semi-axis along y."),
    keyword("load.kind", loads, 0, "Prescribed load: the normal force, or the approach of the bodies."),
    number("load.kind_number", "load.kind", loads, "Overrides load.kind: 0 force, 1 approach; -1: load.kind applies."),
    real("load.Fn", Role::input, "N", 50e3, "Normal force, if prescribed."),
    real("load.approach", Role::input, "mm", 0.05, "Approach, if prescribed."),
    keyword("motion.kind", motions, 0,
            "steady: steady rolling. transient: rolling that continues the previous step, over velocity times step "
            "size. shift: sliding that continues the previous step."),
    number("motion.kind_number", "motion.kind", motions,
           "Overrides motion.kind: 0 steady, 1 transient, 2 shift; -1: motion.kind applies."),
    real("motion.xi", Role::input, "", 0, "Longitudinal creepage of rolling."),
    real("motion.eta", Role::input, "", 0, "Lateral creepage of rolling."),
    real("motion.phi", Role::input, "rad/mm", 0, "Spin of rolling."),
    real("motion.velocity", Role::input, "mm/s", 20e3, "Rolling velocity."),
    real("motion.chi", Role::tunable, "rad", 0, "Rolling direction, from x to y."),
    real("motion.shift_x", Role::input, "mm/s", 0,
         "Velocity of a shift along x, of the upper body relative to the lower one."),
    real("motion.shift_y", Role::input, "mm/s", 0, "Velocity of a shift along y."),
    real("motion.shift_turn", Role::input, "rad/s", 0, "Angular velocity of a shift about z."),
    boolean("force.prescribe_x", Role::parameter, false,
            "True to prescribe the force along x. The motion along x is then an initial estimate."),
    boolean("force.prescribe_y", Role::parameter, false,
            "True to prescribe the force along y. The motion along y is then an initial estimate."),
    real("force.x", Role::input, "N", 0, "Force on the upper body along x, if prescribed."),
    real("force.y", Role::input, "N", 0, "Force on the upper body along y, if prescribed."),
    real("temperature.upper.bulk_temperature", Role::parameter, "degC", 0,
         "Temperature of the upper body's surface before contact."),
    real("temperature.lower.bulk_temperature", Role::parameter, "degC", 0,
         "Temperature of the lower body's surface before contact."),
    real("Fn", Role::output, "N", 0, "Normal force."),
    real("Fx", Role::output, "N", 0, "Force on the upper body along x."),
    real("Fy", Role::output, "N", 0, "Force on the upper body along y."),
    real("Mz", Role::output, "N.mm", 0, "Moment on the upper body about z."),
    real("approach", Role::output, "mm", 0, "Approach of the bodies, prescribed or computed."),
    real("pmax", Role::output, "N/mm2", 0, "Largest pressure."),
    real("area.contact", Role::output, "mm2", 0, "Area in contact."),
    real("area.adhesion", Role::output, "mm2", 0, "Area of adhesion."),
    real("area.slip", Role::output, "mm2", 0, "Area of slip."),
    real("xi", Role::output, "", 0, "Longitudinal creepage of rolling, prescribed or computed."),
    real("eta", Role::output, "", 0, "Lateral creepage of rolling, prescribed or computed."),
    real("power", Role::output, "N.mm/s", 0, "Power that friction dissipates in rolling."),
    real("work", Role::output, "N.mm", 0, "Energy that friction dissipated in the last step of a shift."),
    real("resistance", Role::output, "N", 0, "Force by which the creep of viscoelastic bodies resists rolling."),
    integer("patches", Role::output, 0, "1 in contact, 0 without contact."),
    boolean("converged", Role::output, false, "True if all solvers reached their tolerances."),
});
}  // namespace detail

inline constexpr auto contact_variables = joined(common_variables, detail::contact_alone);

}  // namespace contactd::fmu
