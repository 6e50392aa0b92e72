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
    boolean("upper.rigid", Role::parameter, false, "The upper body does not deform."),
    keyword("upper.coefficients", coefficients, 0,
            "What the upper body is: in closed form, by finite elements, layered, or viscoelastic."),
    number("upper.coefficients_number", "upper.coefficients", coefficients,
           "In the place of upper.coefficients: 0 half_space, 1 half_space_by_elements, 2 block_by_elements, 3 layer, "
           "4 viscoelastic; -1: as upper.coefficients says."),
    real("upper.layer.thickness", Role::parameter, "mm", 1,
         "Of the layer on the upper body, whose base has upper.G and upper.nu."),
    real("upper.layer.G", Role::parameter, "N/mm2", 82000, "Shear modulus of this layer."),
    real("upper.layer.nu", Role::parameter, "", 0.28, "Poisson's ratio of this layer."),
    real("upper.viscoelastic.f", Role::parameter, "", 1,
         "Of a viscoelastic upper body: its delayed compliance over that at once, which upper.G has."),
    real("upper.viscoelastic.tau", Role::parameter, "s", 0.01, "Retardation time of its creep."),
    real("lower.G", Role::parameter, "N/mm2", 82000, "The same of the lower body."),
    real("lower.nu", Role::parameter, "", 0.28, "The same of the lower body."),
    boolean("lower.rigid", Role::parameter, false, "The same of the lower body."),
    keyword("lower.coefficients", coefficients, 0, "The same of the lower body."),
    number("lower.coefficients_number", "lower.coefficients", coefficients,
           "The same of the lower body; -1: as that says."),
    real("lower.layer.thickness", Role::parameter, "mm", 1, "The same of the lower body."),
    real("lower.layer.G", Role::parameter, "N/mm2", 82000, "The same of the lower body."),
    real("lower.layer.nu", Role::parameter, "", 0.28, "The same of the lower body."),
    real("lower.viscoelastic.f", Role::parameter, "", 1, "The same of the lower body."),
    real("lower.viscoelastic.tau", Role::parameter, "s", 0.01, "The same of the lower body."),
    real("elements.accuracy", Role::parameter, "", 1e-3, "Largest relative error of coefficients by finite elements."),
    real("elements.L_over_h", Role::parameter, "", 640, "Of a block: half its width over the size of an element."),
    keyword("gap.kind", gaps, 0,
            "radii: h = x^2/(2 Rx) + y^2/(2 Ry). semi_axes: that of a Hertzian contact with these."),
    number("gap.kind_number", "gap.kind", gaps,
           "In the place of gap.kind: 0 radii, 1 semi_axes; -1: as gap.kind says."),
    real("gap.Rx", Role::tunable, "mm", 460, "Combined radius of curvature along x."),
    real("gap.Ry", Role::tunable, "mm", 300, "Combined radius of curvature along y."),
    real("gap.a", Role::tunable, "mm", 6, "Semi-axis along x."),
    real("gap.b", Role::tunable, "mm", 4, "Semi-axis along y."),
    keyword("load.kind", loads, 0, "What is prescribed: the normal force, or the approach of the bodies."),
    number("load.kind_number", "load.kind", loads,
           "In the place of load.kind: 0 force, 1 approach; -1: as load.kind says."),
    real("load.Fn", Role::input, "N", 50e3, "Normal force, where it is prescribed."),
    real("load.approach", Role::input, "mm", 0.05, "Approach, where it is prescribed."),
    keyword("motion.kind", motions, 0,
            "steady: rolling in its steady state. transient: rolling on from the step before, by velocity times step "
            "size. shift: sliding on from the step before."),
    number("motion.kind_number", "motion.kind", motions,
           "In the place of motion.kind: 0 steady, 1 transient, 2 shift; -1: as motion.kind says."),
    real("motion.xi", Role::input, "", 0, "Longitudinal creepage of rolling."),
    real("motion.eta", Role::input, "", 0, "Lateral creepage of rolling."),
    real("motion.phi", Role::input, "rad/mm", 0, "Spin of rolling."),
    real("motion.velocity", Role::input, "mm/s", 20e3, "Of rolling."),
    real("motion.chi", Role::tunable, "rad", 0, "Direction of rolling, from x to y."),
    real("motion.shift_x", Role::input, "mm/s", 0,
         "Velocity of a shift along x: of the upper body, against the lower."),
    real("motion.shift_y", Role::input, "mm/s", 0, "Velocity of a shift along y."),
    real("motion.shift_turn", Role::input, "rad/s", 0, "Angular velocity of a shift about z."),
    boolean("force.prescribe_x", Role::parameter, false,
            "The force along x is prescribed; the motion along x is the estimate of what is found."),
    boolean("force.prescribe_y", Role::parameter, false, "The same along y."),
    real("force.x", Role::input, "N", 0, "Force on the upper body along x, where it is prescribed."),
    real("force.y", Role::input, "N", 0, "Force on the upper body along y, where it is prescribed."),
    real("temperature.upper.bulk_temperature", Role::parameter, "degC", 0,
         "Of the upper body, where its surface has not been in contact."),
    real("temperature.lower.bulk_temperature", Role::parameter, "degC", 0, "The same of the lower body."),
    real("Fn", Role::output, "N", 0, "Normal force."),
    real("Fx", Role::output, "N", 0, "Force on the upper body along x."),
    real("Fy", Role::output, "N", 0, "Force on the upper body along y."),
    real("Mz", Role::output, "N.mm", 0, "Moment on the upper body about z."),
    real("approach", Role::output, "mm", 0, "Approach of the bodies, prescribed or found."),
    real("pmax", Role::output, "N/mm2", 0, "Largest pressure."),
    real("area.contact", Role::output, "mm2", 0, "Area in contact."),
    real("area.adhesion", Role::output, "mm2", 0, "Area of adhesion."),
    real("area.slip", Role::output, "mm2", 0, "Area of slip."),
    real("xi", Role::output, "", 0, "Longitudinal creepage of rolling, as prescribed or found."),
    real("eta", Role::output, "", 0, "Lateral creepage of rolling, as prescribed or found."),
    real("power", Role::output, "N.mm/s", 0, "What friction takes in rolling."),
    real("work", Role::output, "N.mm", 0, "What friction took in the last step of a shift."),
    real("resistance", Role::output, "N", 0, "Force by which the creep of viscoelastic bodies resists rolling."),
    integer("patches", Role::output, 0, "1 in contact, 0 apart."),
    boolean("converged", Role::output, false, "All solvers reached their tolerance."),
});
}  // namespace detail

inline constexpr auto contact_variables = joined(common_variables, detail::contact_alone);

}  // namespace contactd::fmu
